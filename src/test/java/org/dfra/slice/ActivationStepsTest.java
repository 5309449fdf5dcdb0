package org.dfra.slice;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.assertj.core.api.Assertions.catchThrowable;
import static org.awaitility.Awaitility.await;

import java.io.IOException;
import java.io.UncheckedIOException;
import java.net.InetAddress;
import java.net.ServerSocket;
import java.nio.file.Files;
import java.nio.file.Path;
import java.time.Duration;
import java.util.Map;
import java.util.UUID;
import net.jini.core.lookup.ServiceTemplate;
import org.dfra.core.config.ConfigurationException;
import org.dfra.core.config.ModuleDescription;
import org.dfra.core.config.Parameters;
import org.dfra.core.config.SourceLocation;
import org.dfra.core.module.ModuleContext;
import org.dfra.example.thermometer.SteadyThermometerImpl;
import org.dfra.example.thermometer.Thermometer;
import org.dfra.example.thermometer.ThermometerProxy;
import org.dfra.example.thermometer.ThermometerServer;
import org.dfra.lifecycle.Readiness;
import org.dfra.river.proxy.LocalModuleRegistry;
import org.dfra.slice.FaultyThermometers.WatchedExporter;
import org.dfra.slice.FaultyThermometers.WatchedImpl;
import org.dfra.testing.EmbeddedReggie;
import org.dfra.testing.ServedModule;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.extension.RegisterExtension;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;

/**
 * What becomes of a module when one of the six activation steps fails: one sentence, no remains.
 */
class ActivationStepsTest {

  private static final String HERE = "org.dfra.slice.FaultyThermometers$";
  private static final String SENTENCE = "/robots/r2.xml:12: module r2/warmth: ";
  private static final Duration PATIENCE = Duration.ofSeconds(20);

  @RegisterExtension static final EmbeddedReggie REGGIE = new EmbeddedReggie();

  @TempDir Path folder;

  private final UUID identity = UUID.randomUUID();

  @BeforeEach
  void forget() {
    WatchedImpl.last = null;
    WatchedExporter.last = null;
  }

  /** A thermometer that can be watched, described in line 12 of a file. */
  private ServedModule<ThermometerServer> module(String proxy, String driver, String jini)
      throws IOException {
    Path configuration = folder.resolve("module.config");
    Files.writeString(configuration, jini);
    ModuleDescription description =
        new ModuleDescription(
            "r2",
            "warmth",
            ThermometerServer.class.getName(),
            proxy,
            driver,
            configuration.toString(),
            false,
            new Parameters("r2/warmth", Map.of()),
            new SourceLocation("/robots/r2.xml", 12));
    ServedModule<ThermometerServer> any =
        ServedModule.of(
                ThermometerServer.class, ThermometerProxy.class, SteadyThermometerImpl.class)
            .joining(REGGIE)
            .withId(identity);
    return any.withDescription(description);
  }

  private static String watched(String rest) {
    return "org.dfra.river.server { serverExporter = new "
        + HERE
        + "WatchedExporter((org.dfra.river.server.Exporters$ServerSettings) $data); }\n"
        + rest;
  }

  @Test
  void allSixStepsServeAModuleThatWasDescribedWell() throws Exception {
    ServedModule<ThermometerServer> good =
        module(ThermometerProxy.class.getName(), HERE + "WatchedImpl", watched(""));
    try (ThermometerServer server = good.serve()) {
      assertThat(WatchedImpl.last.isWorking()).isTrue();
      assertThat(WatchedExporter.last.isExported()).as("by its own configuration").isTrue();
      assertThat(server.acquireLease(Duration.ofSeconds(1))).isNotNull();
      await().atMost(PATIENCE).until(ActivationStepsTest::isRegistered);
    }
    assertNothingIsLeft();
  }

  // Step 2: the properties.

  @Test
  void aJiniConfigurationThatIsNotThereIsNamed() throws IOException {
    ServedModule<ThermometerServer> module =
        module(ThermometerProxy.class.getName(), HERE + "WatchedImpl", "");
    Files.delete(folder.resolve("module.config"));
    assertThatThrownBy(module::serve)
        .isInstanceOf(ConfigurationException.class)
        .hasMessageStartingWith(SENTENCE + "its Jini configuration ")
        .hasMessageContaining(" cannot be used: ")
        .hasMessageContaining(folder.resolve("module.config").toString());
    assertThat(WatchedImpl.last).isNull();
  }

  @Test
  void aJiniConfigurationThatCannotBeParsedIsNamed() throws IOException {
    assertThatThrownBy(
            module(ThermometerProxy.class.getName(), HERE + "WatchedImpl", "this is none")::serve)
        .isInstanceOf(ConfigurationException.class)
        .hasMessageStartingWith(SENTENCE + "its Jini configuration ")
        .hasMessageContaining("module.config:1");
    assertThat(WatchedImpl.last).isNull();
  }

  // Step 3: the driver.

  @ParameterizedTest
  @CsvSource(
      delimiter = '|',
      value = {
        "org.dfra.NoSuchImpl | driver class org.dfra.NoSuchImpl is not on the group's class path;"
            + " add its jar or correct the name",
        "java.lang.String | driver java.lang.String is not a subclass of ModuleImpl that implements"
            + " org.dfra.example.thermometer.Thermometer",
        "org.dfra.drivers.gps.m12.M12PlusImpl | driver org.dfra.drivers.gps.m12.M12PlusImpl is not"
            + " a subclass of ModuleImpl that implements org.dfra.example.thermometer.Thermometer",
        "HERE$ShyImpl | driver HERE$ShyImpl has no public constructor (ModuleContext)",
        "HERE$IdeaImpl | driver HERE$IdeaImpl cannot be made: java.lang.InstantiationException",
        "HERE$BrokenImpl | driver HERE$BrokenImpl cannot be made: java.lang.ArithmeticException:"
            + " / by zero",
        "HERE$LinklessImpl | driver HERE$LinklessImpl cannot be made:"
            + " java.lang.NoClassDefFoundError: com/acme/Port",
        "HERE$StubbornImpl | it cannot be served: java.lang.IllegalStateException: the mast is up",
      })
  void aDriverThatCannotBeUsedIsNamed(String driver, String what) throws IOException {
    assertThatThrownBy(module(ThermometerProxy.class.getName(), named(driver), watched(""))::serve)
        .isInstanceOf(ConfigurationException.class)
        .hasMessage(SENTENCE + named(what));
    assertNothingIsLeft();
  }

  @Test
  void aParameterThatIsMissingIsReportedWithTheModulesPlace() throws IOException {
    assertThatThrownBy(
            module(ThermometerProxy.class.getName(), HERE + "ChoosyImpl", watched(""))::serve)
        .isInstanceOf(ConfigurationException.class)
        .hasMessage(
            "/robots/r2.xml:12: r2/warmth: parameter room is not set; write parameter.room=… in the"
                + " module's properties or <parameter name=\"room\"> in the robot's XML");
    assertNothingIsLeft();
  }

  @Test
  void aParameterThatIsWrongIsReportedWithItsOwnPlace() throws IOException {
    assertThatThrownBy(
            module(ThermometerProxy.class.getName(), HERE + "ChoosyImpl", watched(""))
                    .with("room", "cellar", new SourceLocation("/modules/warmth.properties", 3))
                ::serve)
        .isInstanceOf(ConfigurationException.class)
        .hasMessage(
            "/modules/warmth.properties:3: r2/warmth: parameter room is \"cellar\", which is not a"
                + " room with a window");
    assertNothingIsLeft();
  }

  // Step 4: the proxy.

  @ParameterizedTest
  @CsvSource(
      delimiter = '|',
      value = {
        "org.dfra.NoSuchProxy | proxy class org.dfra.NoSuchProxy is not on the group's class path;"
            + " add its jar or correct the name",
        "java.lang.String | proxy java.lang.String is not a ModuleProxy that implements"
            + " org.dfra.example.thermometer.Thermometer",
        "org.dfra.river.proxy.sensor.GPSProxy | proxy org.dfra.river.proxy.sensor.GPSProxy is not"
            + " a ModuleProxy that implements org.dfra.example.thermometer.Thermometer",
        "HERE$ShyProxy | proxy HERE$ShyProxy has no public constructor (RemoteModule, UUID,"
            + " Identification)",
      })
  void aProxyThatCannotBeUsedIsNamedAndWhatWasBegunIsUndone(String proxy, String what)
      throws IOException {
    assertThatThrownBy(module(named(proxy), HERE + "WatchedImpl", watched(""))::serve)
        .isInstanceOf(ConfigurationException.class)
        .hasMessage(SENTENCE + named(what));
    assertNothingIsLeft();
  }

  @Test
  void anExporterThatCannotExportIsReported() throws Exception {
    try (ServerSocket taken = new ServerSocket(0, 0, InetAddress.getByName("127.0.0.1"))) {
      String port = Integer.toString(taken.getLocalPort());
      String jini =
          "org.dfra.river.server { serverExporter = new net.jini.jeri.BasicJeriExporter("
              + "org.dfra.river.call.Endpoints.tcp(\"127.0.0.1\", "
              + port
              + "), new org.dfra.river.call.DeadlineILFactory()); }";
      assertThatThrownBy(
              module(ThermometerProxy.class.getName(), HERE + "WatchedImpl", jini)::serve)
          .isInstanceOf(ConfigurationException.class)
          .hasMessageStartingWith(SENTENCE + "it cannot be served: java.rmi.server.ExportException")
          .hasMessageContaining("Address already in use");
    }
    assertNothingIsLeft();
  }

  /** It makes JERI export a further object at the port, which nobody guards. */
  @Test
  void anExporterWithDistributedGarbageCollectionIsRefused() throws IOException {
    assertRefused(
        collecting("net.jini.jeri.BasicILFactory"),
        "its Jini configuration "
            + folder.resolve("module.config")
            + " cannot be used: org.dfra.river.server.serverExporter");
  }

  @Test
  void anExporterWithDistributedGarbageCollectionIsRefusedAlsoInsideAnother() throws IOException {
    assertRefused(
        "new net.jini.activation.ActivationExporter(new java.rmi.activation.ActivationID(null), "
            + collecting("org.dfra.river.call.DeadlineILFactory")
            + ")",
        "the exporter of " + ThermometerServer.class.getName());
  }

  /** Its constructor refuses it, so the message has file and line of the Jini configuration. */
  @Test
  void aResurrectingExporterWithDistributedGarbageCollectionIsRefused() throws IOException {
    assertRefused(
        "\nnew org.dfra.river.call.ResurrectingExporter(new java.rmi.activation.ActivationID(null), "
            + collecting("net.jini.jeri.BasicILFactory")
            + ")",
        folder.resolve("module.config") + ":2: ");
  }

  private static String collecting(String factory) {
    return "new net.jini.jeri.BasicJeriExporter(org.dfra.river.call.Endpoints.tcp(\"127.0.0.1\", 0),"
        + " new "
        + factory
        + "(), true, true)";
  }

  private void assertRefused(String exporter, String what) throws IOException {
    String jini = "org.dfra.river.server { serverExporter = " + exporter + "; }";
    assertThatThrownBy(module(ThermometerProxy.class.getName(), HERE + "WatchedImpl", jini)::serve)
        .isInstanceOf(ConfigurationException.class)
        .hasMessageStartingWith(SENTENCE)
        .hasMessageContaining(what)
        .hasMessageContaining(" uses distributed garbage collection, ")
        .hasMessageContaining("give BasicJeriExporter false as its third argument, or none");
    assertNothingIsLeft();
  }

  // Step 5: discovery and join.

  @ParameterizedTest
  @ValueSource(strings = {"registrar", "http://registrar:4160", "jini://registrar:99999"})
  void aLocatorThatIsNoneIsNamedAndWhatWasBegunIsUndone(String locator) throws IOException {
    assertThatThrownBy(
            module(ThermometerProxy.class.getName(), HERE + "WatchedImpl", watched(""))
                    .joining(locator)
                ::serve)
        .isInstanceOf(ConfigurationException.class)
        .hasMessage(
            SENTENCE
                + "the locator \""
                + locator
                + "\" is not of the form jini://host or jini://host:port");
    assertNothingIsLeft();
  }

  // Step 6: the landlord.

  @Test
  void leaseTermsThatContradictThemselvesAreReportedAndWhatWasBegunIsUndone() throws IOException {
    String jini = watched("org.dfra.river.lease { longestLease = 10L; defaultLease = 20L; }");
    assertThatThrownBy(module(ThermometerProxy.class.getName(), HERE + "WatchedImpl", jini)::serve)
        .isInstanceOf(ConfigurationException.class)
        .hasMessage(
            SENTENCE
                + "its Jini configuration "
                + folder.resolve("module.config")
                + " cannot be used: org.dfra.river.lease: defaultLease 20 ms > longestLease 10 ms");
    assertNothingIsLeft();
  }

  private static String named(String text) {
    return text.replace("HERE$", HERE);
  }

  private void assertNothingIsLeft() {
    if (WatchedImpl.last != null) {
      assertThat(WatchedImpl.last.readiness()).isEqualTo(Readiness.STOPPED);
      assertThat(WatchedImpl.last.thread.isAlive()).as("the driver's thread lives").isFalse();
      assertThat(catchThrowable(() -> WatchedImpl.last.connect()))
          .as("the driver's port")
          .isInstanceOf(java.net.ConnectException.class);
    }
    if (WatchedExporter.last != null) {
      assertThat(WatchedExporter.last.isExported()).as("still exported").isFalse();
    }
    SteadyThermometerImpl other =
        new SteadyThermometerImpl(
            new ModuleContext(
                "r3", "other", new Parameters("r3/other", Map.of()), java.time.Clock.systemUTC()));
    LocalModuleRegistry.register(identity, other); // refused if the failed one were still entered
    LocalModuleRegistry.unregister(identity, other);
    assertThat(isRegistered()).as("in the lookup service").isFalse();
  }

  private static boolean isRegistered() {
    Class<?>[] kinds = {Thermometer.class};
    try {
      return REGGIE.registrar().lookup(new ServiceTemplate(null, kinds, null)) != null;
    } catch (java.rmi.RemoteException e) {
      throw new UncheckedIOException(e);
    }
  }
}
