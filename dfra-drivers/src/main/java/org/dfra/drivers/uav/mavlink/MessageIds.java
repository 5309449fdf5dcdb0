package org.dfra.drivers.uav.mavlink;

/** The numbers of the messages that are read or sent. Source: mavlink.io, common dialect. */
final class MessageIds {

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
