package org.dfra.example.probe;

import static java.nio.charset.StandardCharsets.US_ASCII;

import java.nio.ByteBuffer;
import java.time.Duration;
import java.time.Instant;
import java.util.Locale;
import org.dfra.sim.device.SerialDevice;

/**
 * The probe emulated: it sends {@code T+021.50*hh\n} once in a period, and is set by {@code
 * P10.0\n}.
 */
final class ProbeDevice implements SerialDevice {

  private final double celsius;
  private final StringBuilder command = new StringBuilder();
  private volatile Duration period = Duration.ofSeconds(1);
  private volatile boolean silent;
  private Instant next = Instant.MIN;

  ProbeDevice(double celsius) {
    this.celsius = celsius;
  }

  /** From one line to the next, as it was last set; for any thread. */
  Duration period() {
    return period;
  }

  /** It falls silent, or speaks again; from any thread. */
  void silence(boolean whether) {
    silent = whether;
  }

  /** The line that reports this temperature, degrees Celsius. */
  static byte[] line(double celsius) {
    return checked(String.format(Locale.ROOT, "T%+07.2f", celsius));
  }

  /** The text with its checksum, as the probe sends it. */
  static byte[] checked(String text) {
    int sum = 0;
    for (byte b : text.getBytes(US_ASCII)) {
      sum ^= b;
    }
    return String.format("%s*%02X\n", text, sum).getBytes(US_ASCII);
  }

  @Override
  public void receive(byte[] bytes, int offset, int length, Instant time) {
    for (char c : new String(bytes, offset, length, US_ASCII).toCharArray()) {
      if (c != '\n') {
        command.append(c);
      } else {
        if (command.toString().matches("P\\d{1,2}\\.\\d+")) {
          period = Duration.ofMillis(Math.round(1000 * Double.parseDouble(command.substring(1))));
          next = time.plus(period);
        }
        command.setLength(0);
      }
    }
  }

  @Override
  public void transmit(ByteBuffer out, Instant time) {
    if (!silent && !time.isBefore(next)) {
      next = time.plus(period);
      out.put(line(celsius));
    }
  }
}
