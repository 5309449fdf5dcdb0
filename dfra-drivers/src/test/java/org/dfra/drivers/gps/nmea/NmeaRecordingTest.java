package org.dfra.drivers.gps.nmea;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import com.fasterxml.jackson.databind.JsonNode;
import com.fasterxml.jackson.databind.ObjectMapper;
import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.time.Duration;
import java.time.Instant;
import java.util.ArrayList;
import java.util.List;
import org.dfra.drivers.fixture.SharedData;
import org.dfra.drivers.gps.GpsReceiverProtocol.GpsSolution;
import org.dfra.drivers.gps.GpsReceiverProtocol.SatelliteInView;
import org.dfra.flow.sensor.GpsFix;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/**
 * Sentences that an independent program wrote, between its own reports of the same moments; to our
 * parser the reports are garbage.
 */
class NmeaRecordingTest {

  @ParameterizedTest
  @ValueSource(strings = {"gps/oncore-m12.log.chk", "gps/oncore-binary.log.chk"})
  void agreesWithTheReportsBetweenTheSentences(String recording) throws IOException {
    byte[] bytes = SharedData.bytes(recording);
    List<JsonNode> reports = new ArrayList<>();
    ObjectMapper mapper = new ObjectMapper();
    for (String line : new String(bytes, StandardCharsets.US_ASCII).lines().toList()) {
      if (line.startsWith("{\"class\":\"TPV\"") && mapper.readTree(line).has("lat")) {
        reports.add(mapper.readTree(line));
      }
    }
    List<GpsSolution> reported = new ArrayList<>();
    NmeaEpochAssembler epoch = new NmeaEpochAssembler(Instant::now, reported::add);
    NmeaParser parser = new NmeaParser(epoch::take);
    parser.feed(bytes, 0, bytes.length);
    parser.finish();
    List<GpsFix> fixes =
        reported.stream().map(GpsSolution::fix).filter(fix -> fix.position() != null).toList();
    assertThat(parser.counts().malformed()).isZero();
    assertThat(fixes).hasSameSizeAs(reports).isNotEmpty();
    for (int i = 0; i < fixes.size(); i++) {
      GpsFix fix = fixes.get(i);
      JsonNode report = reports.get(i);
      // Sentences have a ten-millionth of a minute, reports nine decimals of a degree.
      assertThat(fix.position().latitude()).isCloseTo(report.get("lat").asDouble(), within(3e-9));
      assertThat(fix.position().longitude()).isCloseTo(report.get("lon").asDouble(), within(3e-9));
      // Centimetres in the sentences' altitude, millimetres in the separation.
      assertThat(fix.position().height()).isCloseTo(report.get("altHAE").asDouble(), within(0.006));
      // Sentences have hundredths of a second here.
      assertThat(Duration.between(Instant.parse(report.get("time").asText()), fix.utc()).abs())
          .isLessThanOrEqualTo(Duration.ofMillis(10));
    }
    assertThat(epoch.satellites()).isNotEmpty().anyMatch(SatelliteInView::used);
  }
}
