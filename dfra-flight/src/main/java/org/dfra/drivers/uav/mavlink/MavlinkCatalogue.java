package org.dfra.drivers.uav.mavlink;

import io.dronefleet.mavlink.MavlinkDialect;
import io.dronefleet.mavlink.annotations.MavlinkMessageInfo;
import io.dronefleet.mavlink.ardupilotmega.ArdupilotmegaDialect;
import org.jspecify.annotations.Nullable;

/**
 * The known messages: those of the common dialect and of ArduPilot's dialect. Safe for use by
 * several threads.
 */
final class MavlinkCatalogue {

  /** Result of {@link #crcExtra} for an unknown message. */
  static final int UNKNOWN = -1;

  private static final MavlinkDialect DIALECT = new ArdupilotmegaDialect();

  /** Cached results plus 2; 0 is not cached. Every thread computes the same values. */
  private static final short[] EXTRAS = new short[1 << 16];

  private MavlinkCatalogue() {}

  /**
   * The byte that represents the message's definition in its checksum, 0 to 255; {@link #UNKNOWN}
   * for an unknown message, whose frames cannot be distinguished from noise.
   */
  static int crcExtra(int message) {
    if (message < 0 || message >= EXTRAS.length) {
      return UNKNOWN;
    }
    if (EXTRAS[message] == 0) {
      @Nullable Class<?> type = type(message);
      int extra =
          type == null ? UNKNOWN : type.getAnnotation(MavlinkMessageInfo.class).crc() & 0xFF;
      EXTRAS[message] = (short) (extra + 2);
    }
    return EXTRAS[message] - 2;
  }

  /** The message's name in the form of its class, e.g. {@code Attitude}; its number if unknown. */
  static String name(int message) {
    @Nullable Class<?> type = type(message);
    return type == null ? Integer.toString(message) : type.getSimpleName();
  }

  private static @Nullable Class<?> type(int message) {
    return DIALECT.supports(message) ? DIALECT.resolve(message) : null;
  }

  /** The numbers of the messages that are read or sent. Source: mavlink.io, common dialect. */
  static final class MessageIds {

    static final int HEARTBEAT = 0;
    static final int SYS_STATUS = 1;
    static final int SYSTEM_TIME = 2;
    static final int GPS_RAW_INT = 24;
    static final int GLOBAL_POSITION_INT = 33;
    static final int VFR_HUD = 74;
    static final int COMMAND_INT = 75;
    static final int COMMAND_LONG = 76;
    static final int COMMAND_ACK = 77;
    static final int BATTERY_STATUS = 147;
    static final int AUTOPILOT_VERSION = 148;
    static final int EXTENDED_SYS_STATE = 245;
    static final int STATUSTEXT = 253;

    private MessageIds() {}
  }
}
