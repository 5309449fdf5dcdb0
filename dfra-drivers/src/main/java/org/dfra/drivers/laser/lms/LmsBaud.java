package org.dfra.drivers.laser.lms;

import java.util.Optional;

/** The baud rates of the laser's link. It starts at the lowest. */
public enum LmsBaud {
  /** 9600 bits per second, after power-on and reset. */
  B9600(9_600, 0x42, 103),
  /** 19 200 bits per second. */
  B19200(19_200, 0x41, 51),
  /** 38 400 bits per second. */
  B38400(38_400, 0x40, 25),
  /** 500 000 bits per second, over RS-422. */
  B500000(500_000, 0x48, 1);

  private final int rate;
  private final int mode;
  private final int divisor;

  LmsBaud(int rate, int mode, int divisor) {
    this.rate = rate;
    this.mode = mode;
    this.divisor = divisor;
  }

  /** Bits per second. */
  public int rate() {
    return rate;
  }

  /** The operating mode that sets this rate. */
  int mode() {
    return mode;
  }

  /** The rate for a number of bits per second. */
  static Optional<LmsBaud> of(double rate) {
    for (LmsBaud each : values()) {
      if (each.rate == rate) {
        return Optional.of(each);
      }
    }
    return Optional.empty();
  }

  /** The rate for the register in the laser's status, whose lower bits divide a 1 MHz clock. */
  static Optional<LmsBaud> ofRegister(int register) {
    for (LmsBaud each : values()) {
      if (each.divisor == (register & 0x7FFF)) {
        return Optional.of(each);
      }
    }
    return Optional.empty();
  }
}
