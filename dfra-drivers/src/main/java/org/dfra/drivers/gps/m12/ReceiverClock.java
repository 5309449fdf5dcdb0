package org.dfra.drivers.gps.m12;

/**
 * {@code @@Gb}: date and time that the receiver has; its answer to being set and to being asked.
 *
 * @param time date and time, in the scale that the receiver is set to
 * @param localOffset offset of local time from UTC, minutes, + is east; told, not applied
 */
public record ReceiverClock(M12Time time, int localOffset) implements M12Message {

  @Override
  public String id() {
    return "Gb";
  }
}
