package org.dfra.drivers.gps.nmea;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import com.fasterxml.jackson.databind.JsonNode;
import com.fasterxml.jackson.databind.ObjectMapper;
import java.io.ByteArrayOutputStream;
import java.io.File;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.time.Instant;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.Random;
import java.util.TreeMap;
import java.util.concurrent.TimeUnit;
import org.dfra.drivers.fixture.Sentences;
import org.dfra.drivers.gps.GpsReceiverProtocol.GpsSolution;
import org.dfra.flow.sensor.GpsFix;
import org.junit.jupiter.api.Assumptions;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/**
 * Sentences that are made here, read by our parser and by gpsd's {@code gpsdecode}. Skipped where
 * that is not installed (Debian's package gpsd-clients).
 */
@Timeout(120)
class NmeaGpsdecodeTest {

  private static final int MOMENTS = 30;
  private static final long SEED = Long.getLong("dfra.seed", new Random().nextLong());
  private static final Instant BEGIN = Instant.parse("2026-11-21T23:59:45Z"); // over midnight

  @TempDir private Path folder;

  /** Which sentence has the position. */
  @ParameterizedTest
  @ValueSource(strings = {"GGA", "GNS"})
  void agreesWithAnIndependentDecoder(String position) throws Exception {
    byte[] stream = stream(new Random(SEED), position);
    TreeMap<Instant, JsonNode> reports = reports(stream);
    List<GpsSolution> solutions = new ArrayList<>();
    NmeaEpochAssembler epoch = new NmeaEpochAssembler(() -> BEGIN, solutions::add);
    NmeaParser parser = new NmeaParser(epoch::take);
    parser.feed(stream, 0, stream.length);
    assertThat(parser.counts().malformed()).isZero();
    assertThat(solutions).hasSize(MOMENTS);
    int compared = 0;
    for (GpsSolution solution : solutions) {
      GpsFix fix = solution.fix();
      JsonNode report = reports.get(fix.utc());
      if (report == null) {
        continue; // gpsdecode reports no moment before it has learned which sentence is the last
      }
      compared++;
      String seen = "-Ddfra.seed=" + SEED + ": " + report;
      assertThat(fix.mode()).as(seen).isEqualTo(GpsFix.Mode.FIX_3D);
      // Nine decimals of a degree, millimetres, and thousandths in the report.
      assertThat(fix.position().latitude())
          .as(seen)
          .isCloseTo(report.get("lat").asDouble(), within(2e-9));
      assertThat(fix.position().longitude())
          .as(seen)
          .isCloseTo(report.get("lon").asDouble(), within(2e-9));
      assertThat(fix.position().height())
          .as(seen)
          .isCloseTo(report.get("altHAE").asDouble(), within(1e-3));
      assertThat(fix.speed()).as(seen).isCloseTo(report.get("speed").asDouble(), within(1e-3));
      assertThat(fix.course()).as(seen).isCloseTo(report.get("track").asDouble(), within(1e-3));
    }
    assertThat(compared).as("moments that gpsdecode reported").isGreaterThan(MOMENTS / 2);
  }

  private static byte[] stream(Random random, String position) {
    ByteArrayOutputStream all = new ByteArrayOutputStream();
    for (int second = 0; second < MOMENTS; second++) {
      String utc = BEGIN.plusSeconds(second).toString(); // 2026-11-21T23:59:45Z
      String time = utc.substring(11, 19).replace(":", "") + ".00";
      String day = utc.substring(8, 10);
      String place =
          String.format(
              Locale.ROOT,
              "%02d%09.6f,%s,%03d%09.6f,%s",
              random.nextInt(90),
              random.nextInt(60_000_000) / 1e6,
              random.nextBoolean() ? "N" : "S",
              random.nextInt(180),
              random.nextInt(60_000_000) / 1e6,
              random.nextBoolean() ? "E" : "W");
      double knots = random.nextInt(500) / 10.0;
      double course = random.nextInt(3600) / 10.0;
      double altitude = random.nextInt(30_000) / 10.0;
      String motion = String.format(Locale.ROOT, "%.1f,%.1f", knots, course);
      sentence(all, "GNZDA,%s,%s,11,2026,00,00", time, day);
      sentence(all, "GNRMC,%s,A,%s,%s,%s1126,,,A", time, place, motion, day);
      if (position.equals("GGA")) {
        sentence(all, "GNGGA,%s,%s,1,09,0.9,%.1f,M,46.9,M,,", time, place, altitude);
      } else {
        sentence(all, "GNGNS,%s,%s,AAN,14,0.9,%.1f,46.9,,", time, place, altitude);
      }
      sentence(all, "GNVTG,%.1f,T,,M,%.1f,N,%.2f,K,A", course, knots, knots * 1.852);
      sentence(all, "GNGSA,A,3,04,05,,09,12,,,24,,,,,2.5,1.3,2.1");
    }
    return all.toByteArray();
  }

  private static void sentence(ByteArrayOutputStream to, String form, Object... values) {
    to.writeBytes(Sentences.with(String.format(Locale.ROOT, form, values)));
  }

  /** The last report of each moment: gpsdecode may report one before it is complete. */
  private TreeMap<Instant, JsonNode> reports(byte[] stream)
      throws IOException, InterruptedException {
    Path input = Files.write(folder.resolve("stream.nmea"), stream);
    Path output = folder.resolve("reports.json");
    Process decoder =
        new ProcessBuilder(program())
            .redirectInput(input.toFile())
            .redirectOutput(output.toFile())
            .redirectError(ProcessBuilder.Redirect.DISCARD)
            .start();
    try {
      assertThat(decoder.waitFor(60, TimeUnit.SECONDS)).as("gpsdecode has ended").isTrue();
    } finally {
      decoder.destroyForcibly();
    }
    ObjectMapper mapper = new ObjectMapper();
    TreeMap<Instant, JsonNode> reports = new TreeMap<>();
    for (String line : Files.readAllLines(output)) {
      JsonNode report = mapper.readTree(line);
      if (report.path("class").asText().equals("TPV") && report.has("altHAE")) {
        reports.put(Instant.parse(report.get("time").asText()), report);
      }
    }
    return reports;
  }

  private static String program() {
    for (String place : System.getenv("PATH").split(File.pathSeparator)) {
      Path program = Path.of(place, "gpsdecode");
      if (Files.isExecutable(program)) {
        return program.toString();
      }
    }
    return Assumptions.abort("gpsdecode is not installed (Debian's package gpsd-clients)");
  }
}
