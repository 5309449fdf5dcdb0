package org.dfra.sim.device.uav;

/**
 * A command that the vehicle was given.
 *
 * @param sender number of the ground station
 * @param senderComponent number of the part of it
 * @param command {@code MAV_CMD}
 * @param confirmation how often it was sent before, as it says; 0 in {@code COMMAND_INT}
 * @param parameters seven of them; the fifth and sixth are degrees where they are a place
 * @param isCommandInt whether it came as {@code COMMAND_INT}
 */
record ReceivedCommand(
    int sender,
    int senderComponent,
    int command,
    int confirmation,
    double[] parameters,
    boolean isCommandInt) {

  static final int LAND = 21;
  static final int RETURN = 20;
  static final int TAKE_OFF = 22;
  static final int SET_MODE = 176;
  static final int CHANGE_SPEED = 178;
  static final int REPOSITION = 192;
  static final int ARM = 400;
  static final int MESSAGE_INTERVAL = 511;
  static final int REQUEST_MESSAGE = 512;

  /** One of the parameters, 1 to 7. */
  double parameter(int number) {
    return parameters[number - 1];
  }

  /** A parameter that is a whole number, a mode or the like. */
  int whole(int number) {
    return (int) parameter(number);
  }
}
