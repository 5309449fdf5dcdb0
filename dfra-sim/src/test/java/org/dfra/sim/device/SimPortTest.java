package org.dfra.sim.device;

import static java.nio.charset.StandardCharsets.US_ASCII;
import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.io.IOException;
import java.time.Duration;
import java.time.Instant;
import java.util.List;
import java.util.concurrent.CopyOnWriteArrayList;
import org.dfra.drivers.link.LinkAddress;
import org.dfra.drivers.link.SerialLink;
import org.dfra.sim.time.LockStep;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;

@Timeout(60)
class SimPortTest {

  private static final Instant BEGIN = Instant.parse("2026-01-21T07:00:00Z");
  private static final Duration SECOND = Duration.ofSeconds(1);

  private final LockStep time = new LockStep(BEGIN);
  private final EchoDevice device = new EchoDevice(1000); // 10 ms a byte
  private final SimPort port = new SimPort("echo", device, time);
  private final byte[] buffer = new byte[100];

  private SerialLink open() throws IOException {
    return LinkAddress.parse(port.url()).open(time);
  }

  /** Reads on this thread, which moves the time on. */
  private String read(SerialLink link, Duration timeout) {
    int count = link.read(buffer, 0, buffer.length, timeout);
    return count < 0 ? "lost" : new String(buffer, 0, count, US_ASCII);
  }

  @Test
  void carriesBytesAtThePaceOfTheLine() throws IOException {
    port.start();
    try (SerialLink link = open()) {
      link.write("abc".getBytes(US_ASCII));
      assertThat(read(link, SECOND)).isEqualTo("a");
      assertThat(time.instant()).isEqualTo(BEGIN.plusMillis(10));
      time.advance(Duration.ofMillis(30));
      assertThat(read(link, SECOND)).as("what came meanwhile").isEqualTo("bc");
      assertThat(time.instant()).as("it need not wait").isEqualTo(BEGIN.plusMillis(40));
      assertThat(read(link, SECOND)).isEmpty();
      assertThat(time.instant()).as("it waits in vain").isEqualTo(BEGIN.plusMillis(1040));
      assertThat(link).hasToString("sim:echo");
    }
  }

  @Test
  void handsOverWhenTheLinePausesAndAfter20MillisecondsOtherwise() throws IOException {
    device.setBaud(0); // what it gets, it gets at once
    port.start();
    try (SerialLink link = open()) {
      link.write(new byte[10]);
      device.setBaud(10_000); // five bytes from look to look
      assertThat(read(link, SECOND)).as("ten in one look are no pause").hasSize(10);
      assertThat(time.instant()).isEqualTo(BEGIN.plusMillis(10));
      device.setBaud(0);
      for (int i = 0; i < 10; i++) {
        time.after(i * 5_000_000L, () -> device.receive(new byte[9], 0, 9, time.instant()));
      }
      device.setBaud(10_000);
      assertThat(read(link, SECOND)).as("after so many looks").hasSize(4 * 9);
      assertThat(time.instant()).isEqualTo(BEGIN.plusMillis(30));
    }
  }

  @Test
  void aPortOfAnotherSpeedReadsSomethingElse() throws IOException {
    device.setBaud(9600);
    port.start();
    try (SerialLink link = open()) {
      link.setBaud(19_200);
      link.write("hello".getBytes(US_ASCII));
      time.advance(SECOND);
      assertThat(device.got()).isNotEmpty().isNotEqualTo("hello");
      device.setBaud(19_200);
      link.write("there".getBytes(US_ASCII));
      time.advance(SECOND);
      assertThat(device.got()).endsWith("there");
      assertThat(read(link, SECOND)).endsWith("there");
      device.setBaud(9600); // and answers so
      link.setBaud(9600);
      link.write("again".getBytes(US_ASCII));
      time.advance(SECOND);
      link.setBaud(38_400);
      assertThat(read(link, SECOND)).as("it had come before").isEqualTo("again");
      assertThatThrownBy(() -> link.setBaud(5_000_000))
          .isInstanceOf(IOException.class)
          .hasMessage("sim:echo: baud rate 5000000 is outside 1 to 4000000");
    }
    try (SerialLink next = open()) {
      next.write("follows".getBytes(US_ASCII));
      time.advance(SECOND);
      assertThat(read(next, SECOND)).isEqualTo("follows");
    }
  }

  @Test
  void takesNoMoreThanTheReaderHasRoomFor() throws IOException {
    device.setBaud(0);
    port.start();
    try (SerialLink link = open()) {
      link.write("abcde".getBytes(US_ASCII));
      assertThat(link.read(buffer, 7, 2, SECOND)).isEqualTo(2);
      assertThat(new String(buffer, 7, 2, US_ASCII)).isEqualTo("ab");
      assertThat(read(link, SECOND)).isEqualTo("cde");
    }
  }

  @Test
  void aPulledCableIsALostLinkAndCannotBeOpened() throws IOException {
    port.start();
    SerialLink link = open();
    link.write("ab".getBytes(US_ASCII));
    time.advance(Duration.ofMillis(10));
    port.cable().unplug();
    time.advance(Duration.ofMillis(5));
    assertThat(link.isOpen()).isFalse();
    assertThat(read(link, SECOND)).as("what had come").isEqualTo("a");
    assertThat(read(link, SECOND)).isEqualTo("lost");
    assertThat(read(link, SECOND)).isEqualTo("lost");
    assertThatThrownBy(() -> link.write(new byte[1]))
        .isInstanceOf(IOException.class)
        .hasMessage("sim:echo: the simulated device was lost, or the link was closed");
    assertThatThrownBy(this::open)
        .isInstanceOf(IOException.class)
        .hasMessage("sim:echo: the cable of this simulated device is pulled out");
    port.cable().restore();
    try (SerialLink next = open()) {
      next.write("c".getBytes(US_ASCII));
      assertThat(read(next, SECOND)).isEqualTo("c");
    }
  }

  @Test
  void aNewClientTakesThePlaceOfTheOld() throws IOException {
    port.start();
    SerialLink first = open();
    SerialLink second = open();
    assertThat(read(first, SECOND)).isEqualTo("lost");
    second.write("a".getBytes(US_ASCII));
    assertThat(read(second, SECOND)).isEqualTo("a");
    assertThat(device.connections()).isEqualTo(2);
  }

  @Test
  void closeFreesAWaitingReaderAtItsInstant() throws Exception {
    port.start();
    SerialLink link = open();
    List<String> seen = new CopyOnWriteArrayList<>();
    Thread reader =
        time.newThread("reader", () -> seen.add(read(link, SECOND) + " " + time.instant()));
    reader.start();
    time.after(20_000_000, link::close);
    time.advance(SECOND);
    assertThat(seen).containsExactly("lost " + BEGIN.plusMillis(20));
    assertThat(read(link, SECOND)).isEqualTo("lost");
  }

  @Test
  void aReaderThatIsInterruptedGivesTheLinkUp() throws IOException {
    port.start();
    SerialLink link = open();
    Thread.currentThread().interrupt();
    assertThat(read(link, SECOND)).isEqualTo("lost");
    assertThat(Thread.interrupted()).isTrue();
    assertThat(link.isOpen()).isFalse();
  }

  @Test
  void keepsNoMoreThanALittleForADriverThatDoesNotRead() throws IOException {
    device.setBaud(0);
    port.start();
    try (SerialLink link = open()) {
      for (int i = 0; i < 40; i++) {
        link.write(new byte[2000]);
        time.advance(Duration.ofMillis(5));
      }
      int total = 0;
      for (int count; (count = link.read(buffer, 0, buffer.length, Duration.ZERO)) > 0; ) {
        total += count;
      }
      assertThat(total).isEqualTo(65_536);
    }
  }

  @Test
  void startAndCloseDoNothingTheSecondTime() throws IOException {
    port.start();
    port.start();
    SimPort other = new SimPort("echo", new EchoDevice(0), time);
    assertThatThrownBy(other::start)
        .hasMessage("there is a simulated device sim:echo already; name this one otherwise");
    SerialLink link = open();
    port.close();
    port.close();
    assertThat(read(link, SECOND)).isEqualTo("lost");
    assertThatThrownBy(this::open)
        .isInstanceOf(IOException.class)
        .hasMessage(
            "sim:echo: there is no simulated device echo; the simulation has started none yet;"
                + " org.dfra.sim.device.SimPort makes one");
    assertThatThrownBy(port::start).hasMessage("this port was closed; create a new one");
    other.start();
    other.close();
  }
}
