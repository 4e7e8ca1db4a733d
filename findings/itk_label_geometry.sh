#!/bin/sh
# SPDX-License-Identifier: BSD-3-Clause
# ITK has two filters that measure the ellipsoid of a labelled region. In three dimensions, the axes of one are 11 % too short, and they are
# in voxels along the axes of the image, so that a stretched image gives a body of another shape.
#
# ITK 5.2.1 (Debian 12, libinsighttoolkit5-dev 5.2.1-5+deb12u1). An ellipsoid with the whole axes 30, 50 and 80, parallel to the axes of
# the image; the lengths that both filters return, each with its ratio to the true one, seen on 30 November 2026:
#
#   spacing of the voxels   LabelGeometryImageFilter                    LabelImageToShapeLabelMapFilter
#                           GetAxesLength                               GetEquivalentEllipsoidDiameter
#   1, 1, 1                 26.8 (0.89)  44.7 (0.89)   71.6 (0.90)      29.9  50.0  80.1
#   0.5, 0.5, 0.5           53.6 (1.79)  89.4 (1.79)  143.1 (1.79)      30.0  50.0  80.0
#   0.5, 0.5, 2             13.5 (0.45)  89.3 (1.79)  143.0 (1.79)      30.1  49.9  79.9
#
# The first filter takes four times the square root of the second moments in any number of dimensions. That is the axis of an ellipse (an
# ellipse with the axes 40 and 80 has 39.9 and 80.1), but the axis of an ellipsoid is 2 sqrt(5) = 4.47 times that root, which explains 0.89.
# It computes the moments from indices of voxels. The second filter uses physical lengths, and scales the axes to the region's volume.
# Needs g++ and apt-get.
set -eu
dir=$(mktemp -d)
trap 'rm -rf "$dir"' EXIT
cd "$dir"
apt-get download -q libinsighttoolkit5-dev=5.2.1-5+deb12u1 libinsighttoolkit5.2=5.2.1-5+deb12u1 >/dev/null
for package in *.deb; do dpkg -x "$package" .; done
cat >check.cpp <<'END'
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <itkImage.h>
#include <itkImageRegionIteratorWithIndex.h>
#include <itkLabelGeometryImageFilter.h>
#include <itkLabelImageToShapeLabelMapFilter.h>

template <unsigned D> using Image = itk::Image<unsigned char, D>;

template <unsigned D>
typename Image<D>::Pointer draw(std::array<double, D> const &semi_axes, std::array<double, D> const &spacing) {
  auto image = Image<D>::New();
  typename Image<D>::SizeType size;
  for (unsigned k = 0; k < D; k++) size[k] = 2 * static_cast<unsigned>(semi_axes[k] / spacing[k] + 2) + 1;
  image->SetRegions(size);
  image->SetSpacing(spacing.data());
  image->Allocate();
  for (itk::ImageRegionIteratorWithIndex<Image<D>> i(image, image->GetLargestPossibleRegion()); !i.IsAtEnd(); ++i) {
    double sum = 0;
    for (unsigned k = 0; k < D; k++) {
      auto const centre = static_cast<double>(size[k] - 1) / 2;
      sum += std::pow((static_cast<double>(i.GetIndex()[k]) - centre) * spacing[k] / semi_axes[k], 2);
    }
    i.Set(sum <= 1);
  }
  return image;
}

// Semi-axes along the axes of the image, ascending; "expected": ratios of the lengths of the first filter to the true ones.
template <unsigned D>
void measure(std::array<double, D> const &semi_axes, std::array<double, D> const &spacing, std::array<double, D> const &expected) {
  auto const image = draw<D>(semi_axes, spacing);
  auto geometry = itk::LabelGeometryImageFilter<Image<D>>::New();
  geometry->SetInput(image);
  geometry->Update();
  auto shapes = itk::LabelImageToShapeLabelMapFilter<Image<D>>::New();
  shapes->SetInput(image);
  shapes->Update();
  auto const lengths = geometry->GetAxesLength(1);
  auto const diameters = shapes->GetOutput()->GetLabelObject(1)->GetEquivalentEllipsoidDiameter();
  for (unsigned k = 0; k < D; k++) {
    double const axis = 2 * semi_axes[k];
    printf("%u dimensions, spacing %g, axis %g: %.1f (%.2f), %.1f (%.2f)\n", D, spacing[k], axis, lengths[k], lengths[k] / axis, diameters[k],
           diameters[k] / axis);
    if (std::fabs(lengths[k] / axis - expected[k]) > 0.01 || std::fabs(diameters[k] / axis - 1) > 0.01) exit(1);
  }
}

int main() {
  double const ratio = 2 / std::sqrt(5.0);
  measure<2>({20, 40}, {1, 1}, {1, 1});
  measure<3>({15, 25, 40}, {1, 1, 1}, {ratio, ratio, ratio});
  measure<3>({15, 25, 40}, {0.5, 0.5, 0.5}, {2 * ratio, 2 * ratio, 2 * ratio});
  measure<3>({15, 25, 40}, {2, 0.5, 0.5}, {ratio / 2, 2 * ratio, 2 * ratio});
}
END
libraries=$dir/usr/lib
g++ -std=c++17 -O1 -w -Iusr/include/ITK-5.2 check.cpp -o check -L"$libraries" -Wl,-rpath-link,"$libraries" -lITKTransform-5.2 -lITKLabelMap-5.2 \
  -lITKCommon-5.2 -litkvnl_algo-5.2 -litkvnl-5.2 -litksys-5.2
LD_LIBRARY_PATH=$libraries ./check
