#include <pw85.h>

int main(void)
{
    double const r12[3] = {0, 0, 3}, sphere[6] = {1, 0, 0, 1, 0, 1};
    double out[2];
    return pw85_contact(r12, sphere, sphere, out) != PW85_SUCCESS || out[0] != 2.25;
}
