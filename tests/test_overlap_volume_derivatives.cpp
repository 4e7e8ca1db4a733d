// SPDX-License-Identifier: BSD-3-Clause
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include "random_pairs.hpp"
#include "wide.hpp"
#include <pw85.h>
using namespace pw85_tests;
using Fine = Multiprecision<20>;
constexpr double u = 0x1p-53;
using FS = Sample<Fine, 3>;
struct G { Fine x[15]; };
G grad(FS const &p){ auto d=pw85::overlap_volume_gradient(p.r12,p.q1,p.q2); G g; for(int i=0;i<3;++i) g.x[i]=d.r12[i]; for(int i=0;i<6;++i){g.x[3+i]=d.q1[i]; g.x[9+i]=d.q2[i];} return g; }
Fine &num(FS &p,int k){ return k<3? p.r12[k]: k<9? p.q1[k-3]: p.q2[k-9]; }
int main(int argc,char**argv){
  int kind=std::atoi(argv[1]), N=std::atoi(argv[2]);
  Random random(77+kind); double worst=0; double worstm[3]={0,0,0};
  for(int n=0;n<N;++n){
    Sample<double,3> p{};
    if(kind==0){ PairOptions o{}; o.aspect=n%4==0?1.1:n%4==1?3.0:n%4==2?30.0:1000.0; o.mu2_min=1e-3;o.mu2_max=1.0; p=random_pair<3>(random,o);}
    else if(kind==1){ p.q1=random.form(1,3); p.q2=random.form(random.log_uniform(.7,1.4),3); auto nn=random.direction<3>();
      auto p1=1/std::sqrt(pw85::detail::quadratic_form(p.q1,nn))*pw85::product(p.q1,nn); auto p2=1/std::sqrt(pw85::detail::quadratic_form(p.q2,nn))*pw85::product(p.q2,nn);
      p.r12=p1-p2+random.sign()*random.log_uniform(1e-12,1e-3)*nn; }
    else if(kind==2){ // large
      double R=random.log_uniform(10,1e8); p.q1=random.form(1,3); p.q2=random.form(R,3); auto nn=random.direction<3>();
      auto p2=1/std::sqrt(pw85::detail::quadratic_form(p.q2,nn))*pw85::product(p.q2,nn);
      p.r12=-p2+random.uniform(-.5,.5)*nn; }
    else if(kind==3){ for(int i=0;i<3;++i){ p.q1(i,i)=random.log_uniform(1e-12,1); p.q2(i,i)=random.log_uniform(1e-12,1); p.r12[i]=random.uniform(-.5,.5)*(std::sqrt(p.q1(i,i))+std::sqrt(p.q2(i,i))); } }
    else { PairOptions o{}; o.aspect=5; auto q=random_pair<3>(random,o); p=q; double mu2=pw85::contact(p.r12,p.q1,p.q2).mu2; p.r12=std::sqrt((1-random.log_uniform(1e-14,1e-1))/mu2)*p.r12; }
    double d[15]; int st=pw85_overlap_volume_gradient(p.r12.coordinates,p.q1.entries,p.q2.entries,d,d+3,d+9); if(st) continue;
    double vol; pw85_overlap_volume(p.r12.coordinates,p.q1.entries,p.q2.entries,&vol); double w1,w2; pw85_volume(p.q1.entries,&w1); pw85_volume(p.q2.entries,&w2);
    if(vol==0||vol==w1||vol==w2) continue;
    auto e=convert<Fine>(p); G g=grad(e);
    double scale[15]; for(int i=0;i<3;++i) scale[i]=std::fabs(p.r12[i]); int k=0; for(int i=0;i<3;++i) for(int j=i;j<3;++j,++k){ scale[3+k]=std::sqrt(p.q1(i,i)*p.q1(j,j)); scale[9+k]=std::sqrt(p.q2(i,i)*p.q2(j,j)); }
    Fine s[15]; for(auto&x:s) x=0; Fine h=ldexp(Fine(1),-40);
    for(int q=0;q<15;++q){ FS a=e,b=e; num(a,q)+=h*Fine(scale[q]); num(b,q)-=h*Fine(scale[q]); G ga=grad(a),gb=grad(b); for(int i=0;i<15;++i) s[i]+=abs(ga.x[i]-gb.x[i])/(2*h); }
    auto inv=[&](pw85::SymmetricMatrix<Fine,3> const&q){ auto a=pw85::detail::adjugate(q); Fine det=pw85::detail::determinant(q,a); pw85::Vector<double,3> r{}; for(int i=0;i<3;++i) r[i]=std::sqrt(static_cast<double>(Fine(a(i,i)/det))); return r; };
    auto i1=inv(e.q1), i2=inv(e.q2); double v=std::fmin(w1,w2); auto is = w1<=w2? i1:i2;
    double m[15]; for(int i=0;i<3;++i) m[i]=v*is[i]; k=0; for(int i=0;i<3;++i) for(int j=i;j<3;++j,++k){ m[3+k]=v*.5*(is[i]*i1[j]+is[j]*i1[i]); m[9+k]=v*.5*(is[i]*i2[j]+is[j]*i2[i]); if(i!=j){m[3+k]*=2;m[9+k]*=2;} }
    double big=0; int arg=0; for(int i=0;i<15;++i){ double err=std::fabs(static_cast<double>(Fine(Fine(d[i])-g.x[i])))/(u*(64*m[i]+16*static_cast<double>(s[i]))); if(!(err<=big)){big=err;arg=i;} worstm[i<3?0:i<9?1:2]=std::fmax(worstm[i<3?0:i<9?1:2],err);}
    if(big>0.6){auto fr=pw85::detail::joint_frame(p.r12,p.q1,p.q2); double dist=0; for(int i=0;i<3;++i) dist=std::fmax(dist,std::fabs(fr.axes[i]*fr.center[i])); auto rim=pw85::detail::accurate_rim_frame(fr); std::printf("  %d big %.3g comp %d axes %.3g %.3g %.3g dist %.3g half_chord %.3g vol/v %.3g swapped %d\n",n,big,arg,fr.axes[0],fr.axes[1],fr.axes[2],dist,rim.half_chord,vol/v,int(fr.swapped));}
 if(!(big<=worst)){ worst=big; if(0)std::printf("%d ratio %.3g comp %d val %.3g m %.3g s %.3g vol/v %.3g\n",n,big,arg,d[arg],m[arg],static_cast<double>(s[arg]),vol/v); std::fflush(stdout);} }
  std::printf("kind %d worst %.3g (%.3g %.3g %.3g)\n",kind,worst,worstm[0],worstm[1],worstm[2]);
}
