package org.dfra.drivers.gps.m12;

/**
 * {@code @@Aw}: the time scale that the receiver reports; its acknowledgement of the command.
 *
 * @param isUtc whether it is UTC; otherwise GPS time
 */
public record TimeScale(boolean isUtc) implements M12Message {

  @Override
  public String id() {
    return "Aw";
  }
}
