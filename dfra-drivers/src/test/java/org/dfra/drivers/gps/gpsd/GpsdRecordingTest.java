package org.dfra.drivers.gps.gpsd;

import static org.assertj.core.api.Assertions.assertThat;

import com.fasterxml.jackson.databind.JsonNode;
import com.fasterxml.jackson.databind.ObjectMapper;
import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.time.Instant;
import java.util.ArrayList;
import java.util.List;
import org.dfra.drivers.fixture.SharedData;
import org.dfra.drivers.gps.gpsd.GpsdMessage.Satellite;
import org.dfra.drivers.gps.gpsd.GpsdMessage.Sky;
import org.dfra.drivers.gps.gpsd.GpsdMessage.Tpv;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/**
 * Reports that a real gpsd wrote, against a general reader of JSON; sentences between are garbage.
 */
class GpsdRecordingTest {

  @ParameterizedTest
  @ValueSource(strings = {"gps/oncore-m12.log.chk", "gps/oncore-binary.log.chk"})
  void readsWhatGpsdWrote(String recording) throws IOException {
    byte[] bytes = SharedData.bytes(recording);
    ObjectMapper mapper = new ObjectMapper();
    List<JsonNode> lines = new ArrayList<>();
    for (String line : new String(bytes, StandardCharsets.US_ASCII).lines().toList()) {
      if (line.startsWith("{")) {
        lines.add(mapper.readTree(line));
      }
    }
    List<GpsdMessage> messages = GpsdParser.parse(bytes);
    assertThat(messages).hasSameSizeAs(lines).isNotEmpty();
    for (int i = 0; i < lines.size(); i++) {
      JsonNode line = lines.get(i);
      assertThat(messages.get(i).name()).isEqualTo(line.get("class").asText());
      if (messages.get(i) instanceof Tpv tpv && line.has("lat")) {
        assertThat(tpv.mode()).isEqualTo(line.get("mode").asInt());
        assertThat(tpv.latitude()).isEqualTo(line.get("lat").asDouble());
        assertThat(tpv.longitude()).isEqualTo(line.get("lon").asDouble());
        assertThat(tpv.height()).isEqualTo(line.get("altHAE").asDouble());
        assertThat(tpv.time()).isEqualTo(Instant.parse(line.get("time").asText()));
      } else if (messages.get(i) instanceof Sky sky && line.has("satellites")) {
        assertThat(sky.satellites())
            .extracting(Satellite::prn)
            .containsExactlyElementsOf(
                line.get("satellites").findValues("PRN").stream().map(JsonNode::asInt).toList());
      }
    }
  }
}
