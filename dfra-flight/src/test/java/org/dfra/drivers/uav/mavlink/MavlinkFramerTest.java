package org.dfra.drivers.uav.mavlink;

import static org.assertj.core.api.Assertions.assertThat;

import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.util.HexFormat;
import java.util.Random;
import org.dfra.drivers.fixture.FrameScannerContract;
import org.dfra.drivers.frame.FrameScanner;
import org.dfra.drivers.uav.mavlink.MavlinkParser.MavlinkFramer;
import org.junit.jupiter.api.Test;

class MavlinkFramerTest extends FrameScannerContract {

  /** Every message that is decoded, and two that are not. */
  private static final int[] IDS = {0, 1, 2, 24, 33, 74, 77, 147, 148, 245, 253, 30, 11_030};

  @Override
  protected FrameScanner scanner() {
    return new MavlinkFramer();
  }

  @Override
  protected void decode(byte[] bytes, int offset, int length) {
    assertThat(MavlinkDecoder.decode(bytes, offset, length).message()).isNotNull();
  }

  @Override
  protected byte[] frame(Random random) {
    byte[] payload = new byte[1 + random.nextInt(255)];
    random.nextBytes(payload);
    int id = IDS[random.nextInt(IDS.length)];
    boolean first = id < 256 && random.nextInt(4) == 0;
    // The checksum does not cover a signature: cut off there, a frame takes in the next one's head.
    boolean signed = random.nextInt(20) == 0;
    return first ? v1(random, id, payload) : v2(random, id, payload, signed);
  }

  @Override
  protected String alphabet() {
    return "\u00FE\u00FD\u00FD\t\u0000\u0000\u0001\u0001";
  }

  @Test
  void refusesAMessageThatIsInNoKnownDialect() {
    byte[] unknown = v2(new Random(1), 60_001, new byte[9], false);
    assertThat(dropped(unknown)).isEqualTo(unknown.length);
  }

  @Test
  void refusesAFrameWithAFlagItMustUnderstandAndDoesNot() {
    byte[] frame = v2(new Random(1), 0, new byte[9], false);
    frame[2] = 2;
    assertThat(dropped(frame)).isEqualTo(frame.length);
  }

  @Test
  void countsWrongChecksumsByThemselves() {
    byte[] frame = v2(new Random(1), 0, new byte[9], false);
    frame[12] ^= 1;
    MavlinkFramer framer = new MavlinkFramer();
    framer.feed(frame, 0, frame.length, (bytes, offset, length) -> {});
    framer.finish((bytes, offset, length) -> {});
    assertThat(framer.checksumErrors()).isEqualTo(1);
    assertThat(framer.frames()).isZero();
    assertThat(framer.droppedBytes()).isEqualTo(frame.length);
  }

  /** The check value of CRC-16/MCRF4XX, with its last byte as the extra one. */
  @Test
  void hasTheProtocolsChecksum() {
    byte[] digits = "12345678".getBytes(java.nio.charset.StandardCharsets.US_ASCII);
    assertThat(MavlinkFramer.checksum(digits, 0, digits.length, '9')).isEqualTo(0x6F91);
  }

  @Test
  void findsAFrameOfMavlink1ThatAnAutopilotSent() {
    byte[] frame = HexFormat.of().parseHex("fe094e010100000000000203510403" + "1c7f");
    int[] found = {0};
    new MavlinkFramer().feed(frame, 0, frame.length, (bytes, at, length) -> found[0] = length);
    assertThat(found[0]).isEqualTo(17);
  }

  private static long dropped(byte[] bytes) {
    MavlinkFramer framer = new MavlinkFramer();
    framer.feed(bytes, 0, bytes.length, (buffer, offset, length) -> {});
    framer.finish((buffer, offset, length) -> {});
    return framer.droppedBytes();
  }

  private static byte[] v1(Random random, int id, byte[] payload) {
    ByteBuffer out = ByteBuffer.allocate(payload.length + 8).order(ByteOrder.LITTLE_ENDIAN);
    out.put((byte) 0xFE).put((byte) payload.length).put((byte) random.nextInt());
    out.put((byte) 1).put((byte) 1).put((byte) id).put(payload);
    return summed(out, id, payload.length + 6);
  }

  private static byte[] v2(Random random, int id, byte[] payload, boolean signed) {
    int length = payload.length + 12 + (signed ? 13 : 0);
    ByteBuffer out = ByteBuffer.allocate(length).order(ByteOrder.LITTLE_ENDIAN);
    out.put((byte) 0xFD).put((byte) payload.length).put((byte) (signed ? 1 : 0)).put((byte) 0);
    out.put((byte) random.nextInt()).put((byte) 1).put((byte) 1);
    out.put((byte) id).put((byte) (id >> 8)).put((byte) (id >> 16)).put(payload);
    return summed(out, id, payload.length + 10);
  }

  private static byte[] summed(ByteBuffer out, int id, int covered) {
    int extra = Math.max(0, MavlinkCatalogue.crcExtra(id));
    int sum = MavlinkFramer.checksum(out.array(), 1, covered, extra);
    return out.putShort(covered, (short) sum).array();
  }
}
