package org.dfra.river.phoenix;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.InputStream;
import java.io.StringReader;
import java.nio.charset.StandardCharsets;
import net.jini.config.ConfigurationFile;
import org.dfra.river.bootstrap.PhoenixProcess;
import org.junit.jupiter.api.Test;

/** What phoenix does where nothing is configured. */
class PhoenixConfigurationTest {

  private static PhoenixConfiguration read(String entries) throws Exception {
    return PhoenixConfiguration.read(
        new ConfigurationFile(
            new StringReader(
                "org.dfra.river.phoenix { persistenceDirectory = \"/j\"; " + entries + " }"),
            new String[0]),
        SecretIdentities.fresh());
  }

  /** It would give the system's secret identity to every user of the computer. */
  @Test
  void thereIsNoReadOnlyRegistryUnlessItsPortIsConfigured() throws Exception {
    assertThat(read("").registryPort()).isEqualTo(-1);
    assertThat(read("registryPort = 1098;").registryPort()).isEqualTo(1098);
  }

  @Test
  void theConfigurationThatComesWithDfraNamesNoRegistryPort() throws Exception {
    try (InputStream file = PhoenixProcess.class.getResourceAsStream("phoenix.config")) {
      assertThat(file).isNotNull();
      assertThat(new String(file.readAllBytes(), StandardCharsets.UTF_8))
          .contains("org.dfra.river.phoenix")
          .doesNotContain("registryPort");
    }
  }
}
