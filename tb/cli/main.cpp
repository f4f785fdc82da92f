#include <chrono>
#include <cstdio>
#include "tb/bench.h"
#include "model/linear/host.h"
#include "model/circular/host.h"
using namespace cosim;
int main(){
  for (auto& b: benches()) {
    auto t=std::chrono::steady_clock::now();
    std::uint64_t n=0;
    for(std::uint64_t i=0;i<20;i++){ Run r=b->run_hostile({1,i,10000}); n+=r.clocks;
      if(r.mismatch){ std::printf("%s", to_text(*r.mismatch).c_str()); break;} }
    std::chrono::duration<double> d=std::chrono::steady_clock::now()-t;
    std::printf("%s %lu clocks %.1f ns/clock\n", b->title().c_str(), n, d.count()*1e9/double(n));
    t=std::chrono::steady_clock::now();
    for(std::uint64_t i=0;i<1000;i++) b->run_hostile({1,i,0});
    d=std::chrono::steady_clock::now()-t;
    std::printf("construct %.2f us\n", d.count()*1e3);
  }
}
