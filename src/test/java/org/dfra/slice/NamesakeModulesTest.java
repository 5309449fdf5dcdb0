package org.dfra.slice;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.awaitility.Awaitility.await;

import java.nio.file.Path;
import java.rmi.RemoteException;
import java.time.Duration;
import org.dfra.core.module.ModuleContext;
import org.dfra.core.module.ModuleDependency;
import org.dfra.core.module.SensorImpl;
import org.dfra.directory.ModuleQuery;
import org.dfra.example.thermometer.SteadyThermometerImpl;
import org.dfra.example.thermometer.Thermometer;
import org.dfra.example.thermometer.ThermometerProxy;
import org.dfra.example.thermometer.ThermometerServer;
import org.dfra.lifecycle.Readiness;
import org.dfra.module.NotReadyException;
import org.dfra.river.lookup.JiniModuleDirectory;
import org.dfra.testing.EmbeddedReggie;
import org.dfra.testing.ServedModule;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.extension.RegisterExtension;
import org.junit.jupiter.api.io.TempDir;

/** Two robots of one name in one team, on two hosts or on one: each uses its own modules only. */
class NamesakeModulesTest {

  private static final Duration PATIENCE = Duration.ofSeconds(60);

  @RegisterExtension static final EmbeddedReggie REGGIE = new EmbeddedReggie();

  /** Says what another thermometer of its robot says, as a schema or a behaviour would use it. */
  public static final class SecondHandImpl extends SensorImpl implements Thermometer {

    private final ModuleDependency<Thermometer> first;

    /** Called by the module's server. */
    public SecondHandImpl(ModuleContext context) {
      super(context, "Thermometer that asks another", "you", "1.0");
      this.first = ModuleDependency.of(context, Thermometer.class, "first");
    }

    @Override
    protected void onStart() {
      transitionTo(Readiness.READY);
    }

    @Override
    protected void onClose() {}

    @Override
    public double updateRate() {
      return 0;
    }

    @Override
    public double celsius() throws RemoteException {
      return first.resolve().celsius();
    }
  }

  private static ServedModule<ThermometerServer> first(String host, double celsius) {
    return ServedModule.of(
            ThermometerServer.class, ThermometerProxy.class, SteadyThermometerImpl.class)
        .named("first")
        .with("celsius", Double.toString(celsius))
        .at(host)
        .joining(REGGIE);
  }

  @Test
  void aModuleNeverUsesOneOfAnotherRobotOfItsRobotsName() throws Exception {
    ServedModule<ThermometerServer> second =
        ServedModule.of(ThermometerServer.class, ThermometerProxy.class, SecondHandImpl.class)
            .named("second")
            .with("first", "first")
            .joining(REGGIE);
    try (JiniModuleDirectory all = REGGIE.directory();
        ThermometerServer other = first("127.0.0.2", 99).serve();
        ThermometerServer asking = second.serve()) {
      assertThat(other).isNotSameAs(asking);
      Thermometer asked =
          all.findFirst(ModuleQuery.of(Thermometer.class).name("second"), PATIENCE)
              .orElseThrow()
              .module();
      ModuleQuery<Thermometer> named = ModuleQuery.of(Thermometer.class).name("first");
      await().atMost(PATIENCE).until(() -> all.find(named).size() == 1);
      assertThatThrownBy(asked::celsius)
          .isInstanceOf(NotReadyException.class)
          .hasMessageContaining("robot/second")
          .hasMessageContaining("there is none");

      try (ThermometerServer own = first(EmbeddedReggie.HOST, 1).serve()) {
        assertThat(own).isNotSameAs(other);
        await()
            .atMost(PATIENCE)
            .ignoreException(NotReadyException.class)
            .until(() -> asked.celsius() == 1);
        await().atMost(PATIENCE).until(() -> all.find(named).size() == 2);
        assertThat(asked.celsius()).isEqualTo(1);
      }
      await().atMost(PATIENCE).until(() -> all.find(named).size() == 1);
      await()
          .atMost(PATIENCE)
          .untilAsserted(
              () -> assertThatThrownBy(asked::celsius).isInstanceOf(NotReadyException.class));
    }
  }

  /** Each has a phoenix and a state folder of its own. */
  @Test
  void norOneOfAnotherRobotOfThatNameOnItsOwnHost(@TempDir Path folder) throws Exception {
    Path here = folder.resolve("here");
    ServedModule<ThermometerServer> second =
        ServedModule.of(ThermometerServer.class, ThermometerProxy.class, SecondHandImpl.class)
            .named("second")
            .with("first", "first")
            .joining(REGGIE)
            .withStateFolder(here);
    ServedModule<ThermometerServer> namesakes = first(EmbeddedReggie.HOST, 99);
    ModuleQuery<Thermometer> named = ModuleQuery.of(Thermometer.class).name("first");
    try (JiniModuleDirectory all = REGGIE.directory();
        ThermometerServer other = namesakes.withStateFolder(folder.resolve("there")).serve();
        ThermometerServer asking = second.serve()) {
      assertThat(other).isNotSameAs(asking);
      Thermometer asked =
          all.findFirst(ModuleQuery.of(Thermometer.class).name("second"), PATIENCE)
              .orElseThrow()
              .module();
      await().atMost(PATIENCE).until(() -> all.find(named).size() == 1);
      assertThatThrownBy(asked::celsius)
          .isInstanceOf(NotReadyException.class)
          .hasMessageContaining("there is none");
      try (ThermometerServer own = first(EmbeddedReggie.HOST, 1).withStateFolder(here).serve()) {
        assertThat(own).isNotSameAs(other);
        await()
            .atMost(PATIENCE)
            .ignoreException(NotReadyException.class)
            .until(() -> asked.celsius() == 1);
        await().atMost(PATIENCE).until(() -> all.find(named).size() == 2);
        assertThat(asked.celsius()).isEqualTo(1);
      }
      await().atMost(PATIENCE).until(() -> all.find(named).size() == 1);
      await()
          .atMost(PATIENCE)
          .untilAsserted(
              () -> assertThatThrownBy(asked::celsius).isInstanceOf(NotReadyException.class));
    }
  }
}
