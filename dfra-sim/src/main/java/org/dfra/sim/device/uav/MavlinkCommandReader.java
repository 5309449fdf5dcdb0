package org.dfra.sim.device.uav;

import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.util.Arrays;
import org.dfra.sim.device.uav.MavlinkFrameWriter.MavlinkMessageType;

/**
 * Parses a ground station's heartbeats and commands for one vehicle. It ignores all other frames
 * and damaged ones. Confined to one thread.
 */
final class MavlinkCommandReader {

  /** Receives parsed messages. */
  interface Listener {

    /** A heartbeat of the ground station. */
    void heartbeat(int sender);

    /** A command for this vehicle. */
    void commandReceived(ReceivedCommand command);
  }

  private static final int GROUND_STATION = 6;
  private static final int LONGEST = 280;

  private final int vehicle;
  private final Listener listener;
  private final byte[] window = new byte[LONGEST];
  private int filled;

  MavlinkCommandReader(int vehicle, Listener listener) {
    this.vehicle = vehicle;
    this.listener = listener;
  }

  /** Another computer is connected: discards an incomplete frame. */
  void forget() {
    filled = 0;
  }

  void take(byte[] bytes, int offset, int length) {
    for (int i = offset; i < offset + length; i++) {
      window[filled++] = bytes[i];
      while (filled > 0 && !mayGrow()) {
        int used = Math.max(1, frameLength());
        System.arraycopy(window, used, window, 0, filled - used);
        filled -= used;
      }
    }
  }

  private boolean mayGrow() {
    if ((window[0] & 0xFF) != MavlinkFrameWriter.MARK || (filled > 2 && window[2] != 0)) {
      return false;
    }
    return filled < 2 || filled < length();
  }

  private int length() {
    return MavlinkFrameWriter.HEAD + (window[1] & 0xFF) + MavlinkFrameWriter.TAIL;
  }

  /** Consumes the frame at the beginning; returns its length, 0 when there is none. */
  private int frameLength() {
    if ((window[0] & 0xFF) != MavlinkFrameWriter.MARK
        || filled < MavlinkFrameWriter.HEAD
        || filled < length()) {
      return 0;
    }
    int id = (window[7] & 0xFF) | (window[8] & 0xFF) << 8 | (window[9] & 0xFF) << 16;
    MavlinkMessageType message = MavlinkMessageType.of(id);
    if (message == null) {
      return length(); // not for us, and its checksum is unknown
    }
    int end = length() - MavlinkFrameWriter.TAIL;
    int sum = MavlinkFrameWriter.sum(window, 1, end, message.extra());
    if (window[end] != (byte) sum || window[end + 1] != (byte) (sum >> 8)) {
      return 0;
    }
    byte[] payload = Arrays.copyOf(Arrays.copyOfRange(window, MavlinkFrameWriter.HEAD, end), 255);
    read(message, ByteBuffer.wrap(payload).order(ByteOrder.LITTLE_ENDIAN));
    return length();
  }

  private void read(MavlinkMessageType message, ByteBuffer in) {
    int sender = window[5] & 0xFF;
    if (message == MavlinkMessageType.HEARTBEAT && in.get(4) == GROUND_STATION) {
      listener.heartbeat(sender);
    } else if (message == MavlinkMessageType.COMMAND_LONG && isForUs(in.get(30), in.get(31))) {
      double[] parameters = new double[7];
      for (int i = 0; i < parameters.length; i++) {
        parameters[i] = in.getFloat(4 * i);
      }
      int confirmation = in.get(32) & 0xFF;
      listener.commandReceived(
          new ReceivedCommand(
              sender, window[6] & 0xFF, in.getShort(28), confirmation, parameters, false));
    } else if (message == MavlinkMessageType.COMMAND_INT && isForUs(in.get(30), in.get(31))) {
      double[] parameters = new double[7];
      for (int i = 0; i < 4; i++) {
        parameters[i] = in.getFloat(4 * i);
      }
      parameters[4] = in.getInt(16) / 1e7;
      parameters[5] = in.getInt(20) / 1e7;
      parameters[6] = in.getFloat(24);
      listener.commandReceived(
          new ReceivedCommand(sender, window[6] & 0xFF, in.getShort(28), 0, parameters, true));
    }
  }

  private boolean isForUs(byte system, byte component) {
    return ((system & 0xFF) == vehicle || system == 0) && (component == 0 || component == 1);
  }

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
}
