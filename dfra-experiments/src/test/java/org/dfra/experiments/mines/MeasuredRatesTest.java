package org.dfra.experiments.mines;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.Reader;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Map;
import java.util.Properties;
import java.util.TreeMap;
import org.junit.jupiter.api.Test;

/** The rates with which the mine detector is configured are those that were measured last. */
class MeasuredRatesTest {

  private static final Path PROPERTIES =
      Path.of(System.getProperty("dfra.root"), "config/modules/mine-detector.properties");
  private static final String PREFIX = "parameter.";

  /** Twelve of the cameras, four of both together. */
  private static final int RATES = 16;

  @Test
  void thePropertiesAgreeWithTheRecordedBenchmark() throws Exception {
    Properties properties = new Properties();
    try (Reader reader = Files.newBufferedReader(PROPERTIES)) {
      properties.load(reader);
    }
    Map<String, Double> reported = new TreeMap<>();
    for (String key : properties.stringPropertyNames()) {
      if (key.contains("_positive")) {
        reported.put(key.substring(PREFIX.length()), Double.valueOf(properties.getProperty(key)));
      }
    }
    assertThat(reported).hasSize(RATES);
    Map<String, Double> recorded = new TreeMap<>(RecordedRates.last());
    recorded.keySet().retainAll(reported.keySet());
    assertThat(reported)
        .as(
            "%s against the last run in benchmarks/mines.csv; copy what ./dfra bench mines measured",
            PROPERTIES)
        .isEqualTo(recorded);
  }

  /** One lane again: what was recorded can be measured by anybody. */
  @Test
  void aLaneGivesTheSameLooksAgain() {
    assertThat(found(MineLaneObservations.of(1)))
        .isNotEmpty()
        .isEqualTo(found(MineLaneObservations.of(1)));
  }

  private static String found(MineLaneObservations lane) {
    StringBuilder all = new StringBuilder();
    lane.observations()
        .forEach(look -> look.observation().views().forEach(view -> all.append(view.points())));
    return all.toString();
  }
}
