package org.dfra.drivers.uav.mavlink;

/**
 * An intact frame.
 *
 * @param version of MAVLink, 1 or 2
 * @param system ID of the sender, the vehicle, 1 to 255
 * @param component ID of its component, 1 is the autopilot
 * @param sequence counts the sender's frames, 0 to 255 and again from 0
 * @param message its message
 */
public record MavlinkFrame(
    int version, int system, int component, int sequence, MavlinkMessage message) {

  /** How many frames of the same sender are missing between {@code last} and this. */
  int missingSince(int last) {
    return sequence - last - 1 & 0xFF;
  }
}
