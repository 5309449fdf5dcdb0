package org.dfra.example.thermometer;

import static org.assertj.core.api.Assertions.assertThat;

import java.time.Duration;
import org.dfra.river.lookup.JiniModuleDirectory;
import org.dfra.testing.EmbeddedReggie;
import org.dfra.testing.ServedModule;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.extension.RegisterExtension;

class ThermometerTest {

  @RegisterExtension static final EmbeddedReggie REGGIE = new EmbeddedReggie();

  @Test
  void isFoundByWhatItMeasures(JiniModuleDirectory directory) throws Exception {
    ServedModule<ThermometerServer> thermometer =
        ServedModule.of(
                ThermometerServer.class, ThermometerProxy.class, SteadyThermometerImpl.class)
            .with("celsius", "21.5")
            .joining(REGGIE);
    try (ThermometerServer server = thermometer.serve()) {
      Thermometer found = directory.find(Thermometer.class, Duration.ofSeconds(5)).orElseThrow();
      assertThat(found.celsius()).as("straight from the driver, which lives here").isEqualTo(21.5);

      RemoteThermometer remote = (RemoteThermometer) ((ThermometerProxy) found).server();
      assertThat(remote.celsius()).as("as from another machine").isEqualTo(21.5);
    }
  }
}
