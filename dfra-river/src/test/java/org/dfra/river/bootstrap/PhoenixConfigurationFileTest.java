package org.dfra.river.bootstrap;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.InputStream;
import java.nio.charset.StandardCharsets;
import org.junit.jupiter.api.Test;

/** The configuration of phoenix that comes with DFRA. */
class PhoenixConfigurationFileTest {

  /** It would give the system's secret identity to every user of the computer. */
  @Test
  void namesNoRegistryPort() throws Exception {
    try (InputStream file = PhoenixProcess.class.getResourceAsStream("phoenix.config")) {
      assertThat(file).isNotNull();
      assertThat(new String(file.readAllBytes(), StandardCharsets.UTF_8))
          .contains("org.dfra.river.phoenix")
          .doesNotContain("registryPort");
    }
  }
}
