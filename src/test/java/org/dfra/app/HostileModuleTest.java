package org.dfra.app;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.Serializable;
import java.nio.file.Path;
import java.rmi.RemoteException;
import java.time.Duration;
import java.time.Instant;
import java.util.List;
import java.util.Map;
import java.util.UUID;
import net.jini.admin.Administrable;
import net.jini.core.lease.Lease;
import net.jini.lease.LeaseRenewalManager;
import org.dfra.directory.ModuleQuery;
import org.dfra.event.DeliveryPolicy;
import org.dfra.event.ModuleListener;
import org.dfra.event.Subscription;
import org.dfra.example.thermometer.SteadyThermometerImpl;
import org.dfra.example.thermometer.Thermometer;
import org.dfra.example.thermometer.ThermometerProxy;
import org.dfra.example.thermometer.ThermometerServer;
import org.dfra.lease.ModuleLease;
import org.dfra.lifecycle.Readiness;
import org.dfra.module.Identification;
import org.dfra.module.LogLevel;
import org.dfra.module.Module;
import org.dfra.module.ModuleHistory;
import org.dfra.module.Parameter;
import org.dfra.persona.ModuleAttributes;
import org.dfra.report.terminal.ExitCode;
import org.dfra.river.lookup.JiniModuleDirectory;
import org.dfra.river.lookup.SuppliedConfiguration;
import org.dfra.testing.EmbeddedReggie;
import org.dfra.testing.ServedModule;
import org.junit.jupiter.api.AfterAll;
import org.junit.jupiter.api.BeforeAll;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.extension.RegisterExtension;
import org.junit.jupiter.api.io.TempDir;

/** A module whose proxy fails in whatever it is asked keeps nobody from listing the others. */
@Timeout(180)
class HostileModuleTest {

  private static final Duration PATIENCE = Duration.ofSeconds(60);
  private static final String WHY = "java.lang.IllegalStateException: this proxy is broken";

  @RegisterExtension static final EmbeddedReggie REGGIE = new EmbeddedReggie();

  @TempDir static Path folder;

  private static LeaseRenewalManager renewals;
  private static Lease registration;
  private static ThermometerServer served;
  private static JiniModuleDirectory directory;
  private static ModuleLease lease;

  /** A proxy that is no {@link org.dfra.river.proxy.ModuleProxy}. */
  public record Hostile() implements Module, Administrable, Serializable {

    private static IllegalStateException broken() {
      return new IllegalStateException("this proxy is broken");
    }

    @Override
    public Object getAdmin() {
      throw broken();
    }

    @Override
    public Identification identification() {
      throw broken();
    }

    @Override
    public Readiness readiness() {
      throw broken();
    }

    @Override
    public Readiness awaitReadiness(Duration patience) {
      throw broken();
    }

    @Override
    public Subscription subscribe(ModuleListener listener, DeliveryPolicy policy) {
      throw broken();
    }

    @Override
    public ModuleLease acquireLease(Duration duration) {
      throw broken();
    }

    @Override
    public ModuleHistory history() {
      throw broken();
    }

    @Override
    public LogLevel logLevel() {
      throw broken();
    }

    @Override
    public void setLogLevel(LogLevel level) {
      throw broken();
    }

    @Override
    public List<Parameter> parameters() {
      throw broken();
    }

    @Override
    public void setParameter(String name, String text) {
      throw broken();
    }
  }

  @BeforeAll
  static void register() throws Exception {
    ModuleAttributes attributes =
        new ModuleAttributes(
            "robot",
            "hostile",
            "a.Driver",
            EmbeddedReggie.HOST,
            "somebody",
            "1",
            Readiness.FAILED,
            Instant.now(),
            null,
            0);
    registration =
        REGGIE
            .register(
                UUID.randomUUID(), new Hostile(), List.of(attributes), EmbeddedReggie.LEASE_MILLIS)
            .getLease();
    renewals =
        new LeaseRenewalManager(
            new SuppliedConfiguration(
                Map.of("net.jini.lease.LeaseRenewalManager.roundTripTime", () -> 1_000L)));
    renewals.renewUntil(registration, Lease.FOREVER, null);
    served =
        ServedModule.of(
                ThermometerServer.class, ThermometerProxy.class, SteadyThermometerImpl.class)
            .named("good")
            .joining(REGGIE)
            .serve();
    directory = REGGIE.directory();
    lease =
        directory
            .findFirst(ModuleQuery.of(Thermometer.class), PATIENCE)
            .orElseThrow()
            .module()
            .acquireLease(Duration.ofSeconds(30));
  }

  @AfterAll
  static void end() throws RemoteException {
    if (renewals != null) {
      renewals.clear();
    }
    if (lease != null) {
      lease.close();
    }
    if (directory != null) {
      directory.close();
    }
    if (served != null) {
      served.close();
    }
  }

  private static InProcessCommand dfra(String... words) {
    return InProcessCommand.at(REGGIE, folder.resolve("state"), List.of(words));
  }

  @Test
  void leasesOnOtherModulesAreListedAndItIsNamed() {
    InProcessCommand output = dfra("lease", "list");
    assertThat(output.out()).contains("robot/good");
    assertThat(output.err())
        .isEqualTo(
            "dfra: robot/hostile cannot be asked, since its proxy failed: "
                + WHY
                + System.lineSeparator());
    assertThat(output.code()).as("not all is known").isEqualTo(ExitCode.NO_ANSWER);
  }

  @Test
  void modulesAreListedAndItSaysNotWhyItHasFailed() {
    InProcessCommand output = dfra("module", "list", "--json");
    assertThat(output.code()).as(output.err()).isEqualTo(ExitCode.SUCCESS);
    assertThat(output.out()).contains("good", "hostile", "it does not say why (" + WHY + ")");
  }

  @Test
  void personasAreShown() {
    InProcessCommand all = dfra("persona", "list");
    assertThat(all.code()).as(all.err()).isEqualTo(ExitCode.SUCCESS);
    assertThat(all.out()).contains("robot");
    InProcessCommand one = dfra("persona", "show", "robot");
    assertThat(one.code()).as(one.err()).isEqualTo(ExitCode.SUCCESS);
    assertThat(one.out()).contains("good", "hostile");
  }
}
