package org.dfra.sim.device.uav;

/**
 * A command that the vehicle received.
 *
 * @param sender number of the ground station
 * @param senderComponent number of its component
 * @param command {@code MAV_CMD}
 * @param confirmation number of earlier transmissions, as the command reports it; 0 in {@code
 *     COMMAND_INT}
 * @param parameters seven of them; the fifth and sixth are degrees where they are a position
 * @param isCommandInt whether it arrived as {@code COMMAND_INT}
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

  /** A parameter as an integer, such as a mode. */
  int whole(int number) {
    return (int) parameter(number);
  }
}
