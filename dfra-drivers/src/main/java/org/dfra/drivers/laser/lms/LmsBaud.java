package org.dfra.drivers.laser.lms;

import java.util.Optional;

/** The speeds of the laser's line. It wakes at the slowest. */
public enum LmsBaud {
  /** 9600 bits per second, after power-on and reset. */
  B9600(9_600, 0x42, 103),
  /** 19 200 bits per second. */
  B19200(19_200, 0x41, 51),
  /** 38 400 bits per second. */
  B38400(38_400, 0x40, 25),
  /** 500 000 bits per second, by RS-422. */
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

  /** The operating mode that sets it. */
  int mode() {
    return mode;
  }

  /** That of so many bits per second. */
  static Optional<LmsBaud> of(double rate) {
    for (LmsBaud each : values()) {
      if (each.rate == rate) {
        return Optional.of(each);
      }
    }
    return Optional.empty();
  }

  /** That of the register in the laser's status, whose lower bits divide a clock of 1 MHz. */
  static Optional<LmsBaud> ofRegister(int register) {
    for (LmsBaud each : values()) {
      if (each.divisor == (register & 0x7FFF)) {
        return Optional.of(each);
      }
    }
    return Optional.empty();
  }
}
