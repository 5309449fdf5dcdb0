package org.dfra.drivers.gps.m12;

/**
 * {@code @@Bo}: how far GPS time is ahead of UTC.
 *
 * @param seconds GPS time minus UTC; 0 while the receiver does not know it
 */
public record M12UtcOffset(int seconds) implements M12Message {

  @Override
  public String id() {
    return "Bo";
  }

  /** Whether the receiver knows it. */
  public boolean isKnown() {
    return seconds != 0;
  }
}
