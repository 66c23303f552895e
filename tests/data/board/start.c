/* Start of a Cortex-M7 in QEMU: the floating-point unit is switched on, semihosting prints. */
extern int main(void);
extern void initialise_monitor_handles(void);
extern void exit(int);

void _start(void) {
    *(volatile unsigned *)0xE000ED88 |= 0xF << 20;
    __asm volatile("dsb; isb");
    initialise_monitor_handles();
    exit(main());
}

__attribute__((section(".isr_vector"), used)) void *vectors[16] = {(void *)0x20400000, (void *)_start};
void _init(void) {}
void _fini(void) {}
