package org.dfra.drivers.drive.rflex;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.Random;
import org.dfra.drivers.drive.rflex.RflexParser.RflexFramer;
import org.dfra.drivers.fixture.FrameScannerContract;
import org.dfra.drivers.frame.FrameScanner;
import org.junit.jupiter.api.Test;

class RflexFramerTest extends FrameScannerContract {

  @Override
  protected FrameScanner scanner() {
    return new RflexFramer();
  }

  @Override
  protected void decode(byte[] bytes, int offset, int length) {
    assertThat(RflexDecoder.decode(bytes, offset, length)).isNotNull();
  }

  @Override
  protected byte[] frame(Random random) {
    return switch (random.nextInt(6)) {
      case 0, 1 -> of(random, 2, 33, 25);
      case 2 -> of(random, 1, 1, 9);
      case 3 -> of(random, 4, 2, 8 + 3 * random.nextInt(30));
      case 4 -> of(random, 5, 2, 7);
      default -> of(random, 1 + random.nextInt(6), 40, random.nextInt(256));
    };
  }

  @Override
  protected String alphabet() {
    return "\u001B\u001B\u0002\u0003\u0000\u0021\u0019\u0001";
  }

  @Test
  void aDamagedLengthDoesNotMakeItWait() {
    byte[] frame = of(new Random(7), 2, 33, 25);
    byte[] damaged = frame.clone();
    damaged[5] = (byte) 200;
    RflexFramer framer = new RflexFramer();
    int[] found = {0};
    framer.feed(damaged, 0, damaged.length, (bytes, offset, length) -> found[0]++);
    framer.feed(frame, 0, frame.length, (bytes, offset, length) -> found[0]++);
    assertThat(found[0]).isEqualTo(1);
    assertThat(framer.droppedBytes()).isEqualTo(34);
  }

  @Test
  void goesByTheLengthSinceNumbersMayLookLikeAnEnd() {
    byte[] frame = of(new Random(1), 2, 33, 25);
    frame[15] = 0x1B;
    frame[16] = 0x03;
    frame[19] = 0x1B;
    frame[20] = 0x02;
    frame[31] = (byte) RflexFramer.checksum(frame, 2, 31);
    RflexFramer framer = new RflexFramer();
    int[] found = {0};
    framer.feed(frame, 0, frame.length, (bytes, offset, length) -> found[0] = length);
    assertThat(found[0]).isEqualTo(34);
  }

  static byte[] of(Random random, int port, int opcode, int length) {
    byte[] frame = new byte[length + 9];
    random.nextBytes(frame);
    frame[0] = 0x1B;
    frame[1] = 0x02;
    frame[2] = (byte) port;
    frame[3] = 0;
    frame[4] = (byte) opcode;
    frame[5] = (byte) length;
    int sum = 0;
    for (int i = 2; i < length + 6; i++) {
      sum ^= frame[i];
    }
    frame[length + 6] = (byte) sum;
    frame[length + 7] = 0x1B;
    frame[length + 8] = 0x03;
    return frame;
  }
}
