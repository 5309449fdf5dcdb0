package org.dfra.drivers.gps.ubx;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.Random;
import org.dfra.drivers.fixture.FrameScannerContract;
import org.dfra.drivers.frame.FrameScanner;
import org.dfra.drivers.gps.ubx.UbxParser.UbxFramer;
import org.junit.jupiter.api.Test;

class UbxFramerTest extends FrameScannerContract {

  @Override
  protected FrameScanner scanner() {
    return new UbxFramer();
  }

  @Override
  protected void decode(byte[] bytes, int offset, int length) {
    assertThat(UbxDecoder.decode(bytes, offset, length)).isNotNull();
  }

  @Override
  protected byte[] frame(Random random) {
    return switch (random.nextInt(6)) {
      case 0, 1 -> of(random, UbxFramer.NAV_PVT, 92);
      case 2 -> of(random, UbxFramer.NAV_SAT, 8 + 12 * random.nextInt(40));
      case 3 -> of(random, UbxFramer.ACK_ACK, 2);
      case 4 -> of(random, UbxFramer.MON_VER, 40 + 30 * random.nextInt(6));
      default -> of(random, 0x0D03, random.nextInt(200));
    };
  }

  @Override
  protected String alphabet() {
    return "\u00B5\u00B5b\u0001\u0007\\\u0000\u0000";
  }

  @Test
  void aDamagedLengthDoesNotMakeItWait() {
    byte[] frame = UbxCommands.encode(UbxFramer.NAV_PVT, new int[92]);
    byte[] damaged = frame.clone();
    damaged[5] = 3; // 768 bytes more
    UbxFramer framer = new UbxFramer();
    int[] found = {0};
    framer.feed(damaged, 0, damaged.length, (bytes, offset, length) -> found[0]++);
    framer.feed(frame, 0, frame.length, (bytes, offset, length) -> found[0]++);
    assertThat(found[0]).isEqualTo(1);
    assertThat(framer.droppedBytes()).isEqualTo(100);
  }

  private static byte[] of(Random random, int type, int length) {
    return UbxCommands.encode(type, random.ints(length, 0, 256).toArray());
  }
}
