package org.dfra.sim.device.laser;

import static org.assertj.core.api.Assertions.assertThat;

import java.nio.ByteBuffer;
import java.time.Duration;
import java.time.Instant;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.HexFormat;
import java.util.List;
import org.dfra.drivers.laser.lms.LmsConfiguration.LmsUnit;
import org.dfra.drivers.laser.lms.LmsMessage;
import org.dfra.drivers.laser.lms.LmsParser;
import org.dfra.drivers.laser.lms.LmsScan;
import org.dfra.drivers.laser.lms.LmsStatus;
import org.dfra.drivers.laser.lms.MeasuringMode;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

/** The laser's protocol alone, stepped; commands are those of the telegram listing. */
class LmsDeviceTest {

  private static final Instant BEGIN = Instant.parse("2026-01-21T07:33:29Z");
  private static final String RESET = "02 00 01 00 10 34 12";
  private static final String STREAM = "02 00 02 00 20 24 34 08";
  private static final String STOP = "02 00 02 00 20 25 35 08";
  private static final String BAUD_38400 = "02 00 02 00 20 40 50 08";
  private static final String BAUD_500000 = "02 00 02 00 20 48 58 08";
  private static final String INSTALL = "02 00 0A 00 20 00 53 49 43 4B 5F 4C 4D 53 BE C5";
  private static final String ONE_SCAN = "02 00 02 00 30 01 31 18";
  private static final String STATUS = "02 00 01 00 31 15 12";
  private static final String TYPE = "02 00 01 00 3A 1E 12";
  private static final String CONFIGURATION = "02 00 01 00 74 50 12";
  private static final String VARIANT_100_25 = "02 00 05 00 3B 64 00 19 00 E7 72";
  private static final String VARIANT_180_100 = "02 00 05 00 3B B4 00 64 00 97 49";

  private final List<Instant> looks = new ArrayList<>();
  private LmsDevice laser = laser(LmsEmulatorSettings.factoryDefault());
  private Instant now = BEGIN;

  private LmsDevice laser(LmsEmulatorSettings makeup) {
    return new LmsDevice(
        (time, first, step, longest, distances) -> {
          looks.add(time);
          for (int i = 0; i < distances.length; i++) {
            distances[i] = 2 + (first + i * step);
          }
          distances[0] = Double.POSITIVE_INFINITY;
          distances[1] = Double.NaN;
        },
        makeup);
  }

  @Test
  void wakesWithItsNameAndIsDeafBefore() {
    laser = laser(LmsEmulatorSettings.factoryDefault().withWarmUp(Duration.ofSeconds(30)));
    say(STATUS);
    assertThat(run(Duration.ofSeconds(29))).isEmpty();
    List<LmsMessage> woken = parsed(run(Duration.ofSeconds(2)));
    assertThat(woken).hasSize(1);
    assertThat(woken.get(0).name()).isEqualTo("90");
    assertThat(((LmsMessage.TypeReply) woken.get(0)).type()).isEqualTo("LMS200;30106;V02.30");
    assertThat(laser.baud()).isEqualTo(9600);
  }

  @Test
  void acknowledgesWhatItReadsAndOnlyThat() {
    assertThat(ask(STOP)).startsWith(0x06, 0x02, 0x80, 3, 0, 0xA0, 0, 0x10, 0x16, 0x0A).hasSize(10);
    assertThat(ask("02 00 02 00 20 25 35 09")).containsExactly(0x15);
    assertThat(ask("02 00 01 00 7F 5B 12")).as("it knows no 7F").startsWith(0x06).contains(0x92);
    assertThat(ask("02 01 01 00 31 15 13")).as("for another laser").isEmpty();
    assertThat(ask("47 41 52 42 41 47 45 02 00")).as("garbage").isEmpty();
  }

  @Test
  void answersWhatItIsAsked() {
    LmsStatus status = (LmsStatus) only(ask(STATUS));
    assertThat(status.software()).isEqualTo("V02.30");
    assertThat(status.baud().orElseThrow().rate()).isEqualTo(9600);
    assertThat(status.variant().orElseThrow().beams()).isEqualTo(361);
    assertThat(status.unit()).contains(LmsUnit.CM);
    assertThat(only(ask(TYPE)).name()).isEqualTo("BA");
    assertThat(only(ask(CONFIGURATION)).name()).isEqualTo("F4");
    LmsScan scan = (LmsScan) only(ask(ONE_SCAN));
    float[] ranges = scan.ranges(MeasuringMode.of(0).orElseThrow());
    assertThat(ranges[0]).isEqualTo(Float.POSITIVE_INFINITY);
    assertThat(ranges[1]).isNaN();
    assertThat(ranges[180]).as("forward, from right to left").isEqualTo(2f);
    assertThat(ranges[360]).isGreaterThan(ranges[2]);
  }

  @ParameterizedTest
  @CsvSource({"38400, 5.2", "500000, 37.5", "9600, 1.3"})
  void sendsAsManyScansAsTheLineHasRoomFor(int baud, double hertz) {
    laser = laser(LmsEmulatorSettings.factoryDefault().withBaud(baud));
    ask(STREAM);
    looks.clear();
    List<LmsMessage> scans = parsed(run(Duration.ofSeconds(10)));
    assertThat((double) scans.size()).isBetween(hertz * 10 * 0.9 - 1, hertz * 10 + 1);
    assertThat(laser.isStreaming()).isTrue();
    for (int i = 1; i < looks.size(); i++) {
      assertThat(looks.get(i)).as("none is sent twice").isAfter(looks.get(i - 1));
    }
    ask(STOP);
    run(Duration.ofSeconds(2));
    assertThat(run(Duration.ofSeconds(2))).isEmpty();
  }

  @Test
  void changesItsSpeedWhenTheAnswerIsOut() {
    say(BAUD_38400);
    assertThat(laser.baud()).isEqualTo(9600);
    assertThat(parsed(run(Duration.ofMillis(20)))).hasSize(1); // ten bytes and a half take 10.4 ms
    assertThat(laser.baud()).isEqualTo(38_400);
    ask(BAUD_500000);
    assertThat(laser.baud()).isEqualTo(500_000);
    assertThat(((LmsStatus) only(ask(STATUS))).baud().orElseThrow().rate()).isEqualTo(500_000);
  }

  @Test
  void forgetsAllButItsConfigurationWhenItIsReset() {
    ask(VARIANT_100_25);
    ask(BAUD_38400);
    List<LmsMessage> reset = parsed(ask(RESET));
    assertThat(reset.get(0).name()).isEqualTo("91");
    assertThat(reset.get(1).name()).isEqualTo("90"); // after two seconds
    assertThat(laser.baud()).isEqualTo(9600);
    assertThat(((LmsScan) only(ask(ONE_SCAN))).beams()).isEqualTo(361);
  }

  @Test
  void placesItsBeamsOtherwiseButNotWhileItStreams() {
    assertThat(((LmsMessage.VariantReply) only(ask(VARIANT_100_25))).isDone()).isTrue();
    assertThat(((LmsScan) only(ask(ONE_SCAN))).beams()).isEqualTo(401);
    say(STREAM);
    run(Duration.ofSeconds(1));
    say(VARIANT_180_100);
    assertThat(parsed(run(Duration.ofSeconds(3))))
        .anyMatch(LmsMessage.RefusedReply.class::isInstance);
    say(STOP);
    run(Duration.ofSeconds(3));
    assertThat(((LmsMessage.VariantReply) only(ask(VARIANT_180_100))).variant().beams())
        .isEqualTo(181);
  }

  @Test
  void changesItsConfigurationOnlyForWhoKnowsThePassword() {
    byte[] millimetres = new byte[34];
    millimetres[6] = 1;
    assertThat(configure(millimetres).isDone()).isFalse();
    assertThat(((LmsMessage.ModeReply) only(ask(wrongPassword()))).result()).isEqualTo(1);
    assertThat(((LmsMessage.ModeReply) only(ask(INSTALL))).isDone()).isTrue();
    LmsMessage.ConfigurationChangeReply set = configure(millimetres);
    assertThat(set.isDone()).isTrue();
    assertThat(set.configuration().unit()).contains(LmsUnit.MM);
    assertThat(laser.flashWrites()).isEqualTo(1);
    ask(STOP);
    assertThat(configure(new byte[34]).isDone()).as("installation mode is over").isFalse();
    assertThat(((LmsScan) only(ask(ONE_SCAN))).unit()).isEqualTo(LmsUnit.MM);
  }

  private LmsMessage.ConfigurationChangeReply configure(byte[] configuration) {
    byte[] telegram = new byte[41];
    telegram[0] = 2;
    telegram[2] = 35;
    telegram[4] = 0x77;
    System.arraycopy(configuration, 0, telegram, 5, 34);
    return (LmsMessage.ConfigurationChangeReply) only(ask(checked(telegram)));
  }

  private static String wrongPassword() {
    byte[] telegram = HexFormat.ofDelimiter(" ").parseHex(INSTALL);
    telegram[6] = 'X';
    return checked(telegram);
  }

  /** With the right check at its end. */
  private static String checked(byte[] telegram) {
    int check = LmsTelegrams.check(telegram, 0, telegram.length - 2);
    telegram[telegram.length - 2] = (byte) check;
    telegram[telegram.length - 1] = (byte) (check >> 8);
    return HexFormat.ofDelimiter(" ").formatHex(telegram);
  }

  private void say(String hex) {
    byte[] bytes = HexFormat.ofDelimiter(" ").parseHex(hex.toLowerCase(java.util.Locale.ROOT));
    laser.receive(bytes, 0, bytes.length, now);
  }

  /** Says it and listens for three seconds. */
  private byte[] ask(String hex) {
    say(hex);
    return run(Duration.ofSeconds(3));
  }

  private byte[] run(Duration time) {
    java.io.ByteArrayOutputStream all = new java.io.ByteArrayOutputStream();
    ByteBuffer out = ByteBuffer.allocate(4096);
    Instant end = now.plus(time);
    while (now.isBefore(end)) {
      now = now.plusMillis(5);
      out.clear();
      laser.transmit(out, now);
      all.write(out.array(), 0, out.position());
    }
    return all.toByteArray();
  }

  private static List<LmsMessage> parsed(byte[] bytes) {
    return LmsParser.parse(bytes);
  }

  private static LmsMessage only(byte[] bytes) {
    List<LmsMessage> all = LmsParser.parse(bytes);
    assertThat(all).as("%s", Arrays.toString(bytes)).hasSize(1);
    return all.get(0);
  }
}
