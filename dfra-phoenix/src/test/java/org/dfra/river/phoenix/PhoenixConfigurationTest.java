package org.dfra.river.phoenix;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.io.StringReader;
import net.jini.config.ConfigurationFile;
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

  @Test
  void formerNamesOfEntriesWorkButNotBesideTheirNewOnes() throws Exception {
    assertThat(read("restartWorked = 700L; restartLongestDelay = 9000L;").restartPolicy())
        .isEqualTo(read("restartMinReady = 700L; restartMaxDelay = 9000L;").restartPolicy());
    assertThatThrownBy(() -> read("restartWorked = 700L; restartMinReady = 700L;"))
        .hasMessage(
            "org.dfra.river.phoenix.restartMinReady and its old name restartWorked are set; delete"
                + " restartWorked");
  }

  /** It would give the system's secret identity to every user of the computer. */
  @Test
  void thereIsNoReadOnlyRegistryUnlessItsPortIsConfigured() throws Exception {
    assertThat(read("").registryPort()).isEqualTo(-1);
    assertThat(read("registryPort = 1098;").registryPort()).isEqualTo(1098);
  }
}
