package org.dfra.river.phoenix;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.io.StringReader;
import net.jini.config.ConfigurationException;
import net.jini.config.ConfigurationFile;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

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

  @ParameterizedTest
  @ValueSource(strings = {"activatorExporter", "systemExporter", "monitorExporter", "stopExporter"})
  void anExporterWithDistributedGarbageCollectionIsRefused(String entry) {
    assertThatThrownBy(
            () ->
                read(
                    entry
                        + " = new net.jini.jeri.BasicJeriExporter("
                        + "org.dfra.river.call.Endpoints.tcp(\"127.0.0.1\", 0), "
                        + "new net.jini.jeri.BasicILFactory(), true, true);"))
        .isInstanceOf(ConfigurationException.class)
        .hasMessageStartingWith(
            "org.dfra.river.phoenix: " + entry + " uses distributed garbage collection, ")
        .hasMessageEndingWith("give BasicJeriExporter false as its third argument, or none");
  }
}
