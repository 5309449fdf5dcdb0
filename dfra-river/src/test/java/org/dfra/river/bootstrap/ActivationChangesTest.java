package org.dfra.river.bootstrap;

import static org.assertj.core.api.Assertions.assertThat;

import java.time.Instant;
import java.util.List;
import java.util.Map;
import java.util.TreeMap;
import java.util.UUID;
import org.dfra.core.config.ModuleDescription;
import org.dfra.core.config.Parameters;
import org.dfra.core.config.SourceLocation;
import org.dfra.river.server.ModuleActivation;
import org.junit.jupiter.api.Test;

/** The changes for which a running module is restarted. */
class ActivationChangesTest {

  private static ModuleActivation gps(
      String driver, boolean restart, int line, String host, Map<String, String> parameters) {
    Map<String, Parameters.Value> values = new TreeMap<>();
    parameters.forEach(
        (name, text) ->
            values.put(name, new Parameters.Value(text, new SourceLocation("r.xml", line))));
    return new ModuleActivation(
        new ModuleDescription(
            "r",
            "gps",
            "a.Server",
            "a.Proxy",
            driver,
            null,
            restart,
            new Parameters("r/gps", values),
            new SourceLocation("r.xml", line)),
        new UUID(1, 2),
        Instant.EPOCH,
        host,
        List.of("field"),
        List.of(),
        "/state");
  }

  private static final ModuleActivation OLD =
      gps("a.Driver", true, 3, "127.0.0.1", Map.of("link", "tcp://h:1", "rate", "1"));

  @Test
  void linesThatMovedAndWhatCountsAfterACrashAreNone() {
    assertThat(
            ActivationChanges.between(
                OLD,
                gps("a.Driver", false, 9, "127.0.0.1", Map.of("link", "tcp://h:1", "rate", "1"))))
        .isEmpty();
  }

  @Test
  void allThatChangedIsNamed() {
    assertThat(
            ActivationChanges.between(
                OLD, gps("a.Other", true, 3, "h", Map.of("link", "tcp://h:2", "size", "4"))))
        .containsExactly(
            "implementation", "parameter link", "parameter rate", "parameter size", "host");
  }
}
