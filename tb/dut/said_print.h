/* Included by force where Verilator's library is compiled: what its RTL prints comes here. */
#ifdef __cplusplus
int cosim_rtl_print(const char* format, ...) __attribute__((format(printf, 1, 2)));
#endif
