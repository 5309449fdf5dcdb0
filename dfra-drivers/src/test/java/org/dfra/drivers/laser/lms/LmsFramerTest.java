package org.dfra.drivers.laser.lms;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.Random;
import org.dfra.drivers.fixture.FrameScannerContract;
import org.dfra.drivers.frame.FrameScanner;
import org.dfra.drivers.laser.lms.LmsParser.LmsFramer;
import org.junit.jupiter.api.Test;

class LmsFramerTest extends FrameScannerContract {

  private static final int[] REPLIES = {
    0x90, 0x91, 0x92, 0xA0, 0xB1, 0xB2, 0xBA, 0xBB, 0xF4, 0xF7, 0xC5
  };

  @Override
  protected FrameScanner scanner() {
    return new LmsFramer();
  }

  @Override
  protected void decode(byte[] bytes, int offset, int length) {
    assertThat(LmsDecoder.decode(bytes, offset, length)).isNotNull();
  }

  @Override
  protected byte[] frame(Random random) {
    int beams = new int[] {101, 181, 201, 361, 401}[random.nextInt(5)];
    byte[] telegram =
        random.nextInt(3) == 0
            ? Replies.scan(1, random.ints(beams, 0, 65_536).toArray())
            : Replies.telegram(
                REPLIES[random.nextInt(REPLIES.length)],
                random.ints(random.nextInt(200), 0, 256).toArray());
    return random.nextBoolean() ? telegram : Replies.acknowledged(telegram);
  }

  @Override
  protected String alphabet() {
    return "\u0002\u0002\u0080\u0006\u0003\u0000\u00A0\u00B0\u0010";
  }

  @Test
  void aNakIsAFrameOfItsOwn() {
    LmsParser parser = new LmsParser(message -> {});
    parser.feed(new byte[] {0x15, 0x15}, 0, 2);
    assertThat(parser.counts().frames()).isEqualTo(2);
    assertThat(parser.counts().malformed()).as("they show no laser").isEqualTo(2);
  }

  @Test
  void anEchoOfACommandIsNoReply() {
    LmsParser parser = new LmsParser(message -> {});
    byte[] echo = LmsCommands.stream();
    parser.feed(echo, 0, echo.length);
    parser.finish();
    assertThat(parser.counts().frames()).isZero();
    assertThat(parser.counts().droppedBytes()).isEqualTo(echo.length);
  }

  @Test
  void aDamagedLengthDoesNotMakeItWait() {
    byte[] frame = Replies.scan(1, new int[361]);
    byte[] damaged = frame.clone();
    damaged[3] = 7; // 1280 bytes more, which no telegram has
    LmsParser parser = new LmsParser(message -> {});
    parser.feed(damaged, 0, damaged.length);
    parser.feed(frame, 0, frame.length);
    assertThat(parser.counts().frames()).isEqualTo(1);
    assertThat(parser.counts().droppedBytes()).isEqualTo(732);
  }
}
