package org.dfra.sim.device.uav;

import org.jspecify.annotations.Nullable;

/**
 * The messages that are sent or understood, with the CRC extra byte that represents their
 * definition in the checksum. Source: mavlink.io, common dialect.
 */
enum MavlinkMessageType {
  HEARTBEAT(0, 50),
  SYS_STATUS(1, 124),
  SYSTEM_TIME(2, 137),
  GPS_RAW_INT(24, 24),
  GLOBAL_POSITION_INT(33, 104),
  VFR_HUD(74, 20),
  COMMAND_INT(75, 158),
  COMMAND_LONG(76, 152),
  COMMAND_ACK(77, 143),
  BATTERY_STATUS(147, 154),
  AUTOPILOT_VERSION(148, 178),
  EXTENDED_SYS_STATE(245, 130),
  STATUSTEXT(253, 83);

  private final int id;
  private final int extra;

  MavlinkMessageType(int id, int extra) {
    this.id = id;
    this.extra = extra;
  }

  int id() {
    return id;
  }

  int extra() {
    return extra;
  }

  /** The message of that number; null if there is none. */
  static @Nullable MavlinkMessageType of(int id) {
    for (MavlinkMessageType each : values()) {
      if (each.id == id) {
        return each;
      }
    }
    return null;
  }
}
