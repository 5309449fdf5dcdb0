package org.dfra.drivers.gps.m12;

/**
 * {@code @@Gb}: the receiver's date and time; its answer to a set command and to a query.
 *
 * @param time date and time, in the scale that the receiver is set to
 * @param localOffset offset of local time from UTC, minutes, + is east; reported, not applied
 */
public record ReceiverClock(M12Time time, int localOffset) implements M12Message {

  @Override
  public String id() {
    return "Gb";
  }
}
