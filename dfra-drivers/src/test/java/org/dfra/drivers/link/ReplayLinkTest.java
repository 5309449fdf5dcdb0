package org.dfra.drivers.link;

import static java.util.concurrent.TimeUnit.SECONDS;
import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.time.Duration;
import java.util.concurrent.CompletableFuture;
import org.dfra.drivers.fixture.StepTicker;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.io.TempDir;

@Timeout(120)
class ReplayLinkTest {

  private static final Duration SECOND = Duration.ofSeconds(1);

  @TempDir private Path folder;
  private final byte[] recorded = new byte[3000];
  private final byte[] buffer = new byte[4096];
  private final StepTicker ticker = new StepTicker(true); // waits move the time on

  @BeforeEach
  void fill() {
    for (int i = 0; i < recorded.length; i++) {
      recorded[i] = (byte) (i * 31);
    }
  }

  private SerialLink open(String options, Ticker time) throws IOException {
    Path file = Files.write(folder.resolve("recorded.log"), recorded);
    return LinkAddress.parse("replay:" + file + options).open(time);
  }

  @Test
  void playsAllBytesAtThePaceOfTheLine() throws IOException {
    try (SerialLink link = open("?baud=9600", ticker)) {
      long begin = ticker.nanos();
      assertThat(drain(link)).isEqualTo(recorded);
      // 3000 bytes of 10 bits at 9600 bit/s; every wait is rounded up to a whole nanosecond
      assertThat((ticker.nanos() - begin) / 1e9).isBetween(3.125, 3.125001);
      assertThat(link.isOpen()).isFalse();
    }
  }

  @Test
  void playsFasterByItsPace() throws IOException {
    try (SerialLink link = open("?baud=9600&pace=2.5", ticker)) {
      long begin = ticker.nanos();
      drain(link);
      assertThat((ticker.nanos() - begin) / 1e9).isBetween(1.25, 1.250001);
    }
  }

  @Test
  void deliversAByteWhenItsLastBitIsThroughAndNotBefore() throws IOException {
    StepTicker stepped = new StepTicker(false);
    try (SerialLink link = open("?baud=1000", stepped)) { // 10 ms a byte
      assertThat(link.read(buffer, 0, 10, Duration.ZERO)).isZero();
      stepped.step(Duration.ofNanos(9_999_999));
      assertThat(link.read(buffer, 0, 10, Duration.ZERO)).isZero();
      stepped.step(Duration.ofNanos(1));
      assertThat(link.read(buffer, 0, 10, Duration.ZERO)).isOne();
      stepped.step(Duration.ofMillis(55));
      assertThat(link.read(buffer, 0, 3, Duration.ZERO)).isEqualTo(3);
      assertThat(link.read(buffer, 0, 10, Duration.ZERO)).isEqualTo(2);
      assertThat(link.read(buffer, 0, 10, Duration.ZERO)).isZero();
    }
  }

  @Test
  void givesUpAReadAfterItsTimeout() throws IOException {
    try (SerialLink link = open("?baud=50", ticker)) { // 0.2 s a byte
      long begin = ticker.nanos();
      assertThat(link.read(buffer, 0, 10, Duration.ofMillis(50))).isZero();
      assertThat(ticker.nanos() - begin).isEqualTo(50_000_000);
    }
  }

  @Test
  void paceZeroTakesNoTime() throws IOException {
    try (SerialLink link = open("?pace=0", ticker)) {
      long begin = ticker.nanos();
      assertThat(drain(link)).isEqualTo(recorded);
      assertThat(ticker.nanos()).isEqualTo(begin);
    }
  }

  @Test
  void beginsAgainInALoop() throws IOException {
    try (SerialLink link = open("?pace=0&loop=true", ticker)) {
      for (int i = 0; i < 2 * recorded.length; i++) {
        assertThat(link.read(buffer, 0, 1, SECOND)).isOne();
        assertThat(buffer[0]).as("byte %d", i).isEqualTo(recorded[i % recorded.length]);
      }
      assertThat(link.isOpen()).isTrue();
    }
  }

  @Test
  void closeFreesAWaitingReader() throws Exception {
    StepTicker standing = new StepTicker(false);
    SerialLink link = open("", standing);
    CompletableFuture<Integer> read =
        CompletableFuture.supplyAsync(() -> link.read(buffer, 0, 10, Duration.ofHours(1)));
    link.close();
    assertThat(read.get(40, SECONDS)).isEqualTo(-1);
  }

  @Test
  void throwsAwayWhatIsWrittenUntilItHasEnded() throws IOException {
    try (SerialLink link = open("?pace=0", ticker)) {
      link.write(new byte[100]);
      drain(link);
      assertThatThrownBy(() -> link.write(new byte[1]))
          .isInstanceOf(IOException.class)
          .hasMessageEndingWith("the replay has ended");
    }
  }

  private byte[] drain(SerialLink link) {
    ByteArrayOutputStream all = new ByteArrayOutputStream();
    for (int count = 0; count >= 0; count = link.read(buffer, 0, buffer.length, SECOND)) {
      all.write(buffer, 0, count);
    }
    return all.toByteArray();
  }
}
