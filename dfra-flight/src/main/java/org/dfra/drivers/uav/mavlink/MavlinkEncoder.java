package org.dfra.drivers.uav.mavlink;

import io.dronefleet.mavlink.annotations.MavlinkMessageInfo;
import io.dronefleet.mavlink.common.CommandInt;
import io.dronefleet.mavlink.common.CommandLong;
import io.dronefleet.mavlink.common.MavCmd;
import io.dronefleet.mavlink.common.MavFrame;
import io.dronefleet.mavlink.minimal.Heartbeat;
import io.dronefleet.mavlink.minimal.MavAutopilot;
import io.dronefleet.mavlink.minimal.MavState;
import io.dronefleet.mavlink.minimal.MavType;
import io.dronefleet.mavlink.serialization.payload.MavlinkPayloadSerializer;
import io.dronefleet.mavlink.serialization.payload.reflection.ReflectionPayloadSerializer;
import io.dronefleet.mavlink.util.EnumValue;
import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.util.concurrent.atomic.AtomicInteger;
import org.dfra.drivers.uav.mavlink.MavlinkParser.MavlinkFramer;

/**
 * Encodes the frames of one sender, in MAVLink 2, unsigned, with sequence numbers. Safe for use by
 * several threads.
 */
final class MavlinkEncoder {

  /** Component ID of a mission planner in a ground station. */
  static final int COMPONENT = 190;

  private static final MavlinkPayloadSerializer FIELDS = new ReflectionPayloadSerializer();
  private static final int PROTOCOL = 3;

  private final int system;
  private final AtomicInteger sent = new AtomicInteger();

  /**
   * @param system ID of the sender, the ground station, 1 to 255
   */
  MavlinkEncoder(int system) {
    this.system = system;
  }

  /** {@code HEARTBEAT} of a ground station. */
  byte[] heartbeat() {
    return frame(
        Heartbeat.builder()
            .type(MavType.MAV_TYPE_GCS)
            .autopilot(MavAutopilot.MAV_AUTOPILOT_INVALID)
            .baseMode()
            .customMode(0)
            .systemStatus(MavState.MAV_STATE_ACTIVE)
            .mavlinkVersion(PROTOCOL)
            .build());
  }

  /**
   * Encodes a command.
   *
   * @param times how many times it was sent before, 0 to 255; only {@code COMMAND_LONG} has a field
   *     for it
   */
  byte[] command(Vehicle to, MavlinkCommand command, int times) {
    if (command instanceof MavlinkCommand.CommandInt placed) {
      return frame(
          CommandInt.builder()
              .targetSystem(to.system())
              .targetComponent(to.component())
              .frame(MavFrame.MAV_FRAME_GLOBAL)
              .command(placed.id())
              .param1(placed.p1())
              .param2(placed.p2())
              .param3(placed.p3())
              .param4(placed.p4())
              .x(placed.latitude())
              .y(placed.longitude())
              .z(placed.heightMsl())
              .build());
    }
    MavlinkCommand.CommandLong plain = (MavlinkCommand.CommandLong) command;
    return frame(
        CommandLong.builder()
            .targetSystem(to.system())
            .targetComponent(to.component())
            .command(plain.id())
            .confirmation(times)
            .param1(plain.p1())
            .param2(plain.p2())
            .param3(plain.p3())
            .param4(plain.p4())
            .param5(plain.p5())
            .param6(plain.p6())
            .param7(plain.p7())
            .build());
  }

  /** The number of a command. */
  static int number(MavCmd command) {
    return EnumValue.of(command).value();
  }

  private byte[] frame(Object message) {
    MavlinkMessageInfo info = message.getClass().getAnnotation(MavlinkMessageInfo.class);
    byte[] payload = FIELDS.serialize(message);
    int length = payload.length;
    while (length > 1 && payload[length - 1] == 0) { // as the protocol defines
      length--;
    }
    ByteBuffer out =
        ByteBuffer.allocate(MavlinkFramer.HEAD_2 + length + 2).order(ByteOrder.LITTLE_ENDIAN);
    out.put(MavlinkFramer.MARK_2).put((byte) length).put((byte) 0).put((byte) 0);
    out.put((byte) sent.getAndIncrement()).put((byte) system).put((byte) COMPONENT);
    out.put((byte) info.id()).putShort((short) (info.id() >> 8));
    out.put(payload, 0, length);
    int sum = MavlinkFramer.checksum(out.array(), 1, out.position(), info.crc());
    return out.putShort((short) sum).array();
  }
}
