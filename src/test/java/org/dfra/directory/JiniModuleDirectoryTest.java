package org.dfra.directory;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.assertj.core.api.Assertions.tuple;
import static org.awaitility.Awaitility.await;

import java.io.IOException;
import java.time.Duration;
import java.time.Instant;
import java.time.InstantSource;
import java.util.ArrayList;
import java.util.HashMap;
import java.util.HashSet;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.UUID;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.CountDownLatch;
import java.util.concurrent.TimeUnit;
import net.jini.admin.Administrable;
import net.jini.admin.JoinAdmin;
import net.jini.core.lookup.ServiceMatches;
import net.jini.core.lookup.ServiceRegistrar;
import net.jini.core.lookup.ServiceRegistration;
import net.jini.core.lookup.ServiceTemplate;
import org.dfra.core.host.FreePorts;
import org.dfra.core.time.StallProbe;
import org.dfra.core.time.Timing;
import org.dfra.flow.sensor.GPSSensor;
import org.dfra.lifecycle.Readiness;
import org.dfra.persona.Attributes;
import org.dfra.persona.ModuleAttributes;
import org.dfra.persona.PersonaAttributes;
import org.dfra.river.entry.Entries;
import org.dfra.river.lookup.DirectorySettings;
import org.dfra.river.lookup.JiniModuleDirectory;
import org.dfra.river.proxy.LocalModuleRegistry;
import org.dfra.testing.EmbeddedReggie;
import org.junit.jupiter.api.Test;

class JiniModuleDirectoryTest extends DirectoryContract {

  /**
   * Longer than any test: thousands of modules take longer to register than a robot's lease, and on
   * a busy computer some of thousands would be renewed too late.
   */
  private static final Duration LEASE = Duration.ofHours(1);

  /** The requirement for a lookup service that was restarted. */
  private static final Duration FOUND = Duration.ofSeconds(5);

  private static final Duration SHORT_LEASE = Duration.ofSeconds(4);

  /** The requirement of {@code benchmarks/}: staleness of a dead module over its lease, 1.1. */
  private static final Duration DROPPED = SHORT_LEASE.multipliedBy(11).dividedBy(10);

  /** The next heartbeat of {@link #settings}, 0.2 s; 0.3 s for its failure. */
  private static final Duration STALE = Duration.ofMillis(500);

  private final List<EmbeddedReggie> reggies = new ArrayList<>();

  private static DirectorySettings settings(List<String> locators) {
    return new DirectorySettings(
        EmbeddedReggie.HOST,
        List.of(),
        locators,
        Duration.ofMillis(200),
        Duration.ofMillis(200),
        Duration.ofSeconds(3),
        Duration.ofSeconds(30),
        Duration.ofSeconds(5));
  }

  @Override
  Fixture fixture() throws Exception {
    EmbeddedReggie reggie = start(0);
    return new JiniFixture(
        reggie,
        new JiniModuleDirectory(settings(List.of(reggie.locator())), InstantSource.system()));
  }

  /** A lookup service and a client of it. */
  private final class JiniFixture implements Fixture {
    private final EmbeddedReggie reggie;
    private final JiniModuleDirectory directory;
    private final Map<UUID, ServiceRegistration> registrations = new HashMap<>();
    private final Set<ListedGps> local = new HashSet<>();

    JiniFixture(EmbeddedReggie reggie, JiniModuleDirectory directory) {
      this.reggie = reggie;
      this.directory = directory;
    }

    @Override
    public ModuleDirectory directory() {
      return directory;
    }

    @Override
    public void announce(ListedGps module, List<Attributes> attributes, Locality locality)
        throws Exception {
      if (locality == Locality.SAME_VM && local.add(module)) {
        LocalModuleRegistry.register(module.id(), module);
      }
      ServiceRegistration known = registrations.get(module.id());
      if (known != null) {
        known.setAttributes(Entries.toEntries(attributes));
        return;
      }
      registrations.put(module.id(), register(reggie, module, attributes));
    }

    @Override
    public void announce(PersonaAttributes robot) throws Exception {
      // As a robot's registrar receives it; here by a service of its own: reggie is one robot's.
      reggie.register(UUID.randomUUID(), "a registrar", List.of(robot), LEASE.toMillis());
    }

    @Override
    public void withdraw(UUID id) throws Exception {
      registrations.remove(id).getLease().cancel();
    }

    @Override
    public void loseSight() throws Exception {
      reggie.close();
    }

    @Override
    public void close() throws Exception {
      local.forEach(module -> LocalModuleRegistry.unregister(module.id(), module));
      for (EmbeddedReggie each : reggies) {
        each.close();
      }
    }
  }

  private EmbeddedReggie start(int port) throws IOException {
    EmbeddedReggie reggie = new EmbeddedReggie(port, LEASE).start();
    reggies.add(reggie);
    return reggie;
  }

  private static ServiceRegistration register(
      EmbeddedReggie reggie, ListedGps module, List<Attributes> attributes) throws Exception {
    return reggie.register(module.id(), module, attributes, LEASE.toMillis());
  }

  @Test
  void dropsAModuleWhoseLeaseRanOut() throws Exception {
    ListedGps gps = new ListedGps(UUID.randomUUID(), "gps");
    try (StallProbe probe = StallProbe.start()) {
      reggies.get(0).register(gps.id(), gps, attributes("r", "gps", 1), SHORT_LEASE.toMillis());
      StallProbe.Stopwatch leased = probe.stopwatch();
      assertThat(directory.find(GPSSensor.class, PATIENCE)).isPresent();
      await()
          .pollInterval(Duration.ofMillis(20))
          .atMost(PATIENCE)
          .until(() -> directory.find(ModuleQuery.of(GPSSensor.class)).isEmpty());
      Timing dropped = leased.stop();
      System.out.printf("dropped a module with a lease of 4 s: %s%n", dropped);
      dropped.requireWithin("dropping a module after its lease of 4 s", DROPPED);
    }
  }

  @Test
  void aModuleInSeveralLookupServicesIsOneAndFreshWhileOneOfThemHasIt() throws Exception {
    EmbeddedReggie one = reggies.get(0);
    EmbeddedReggie two = start(0);
    ListedGps gps = new ListedGps(UUID.randomUUID(), "gps");
    ModuleQuery<GPSSensor> query = ModuleQuery.of(GPSSensor.class);
    try (JiniModuleDirectory team =
        new JiniModuleDirectory(
            settings(List.of(one.locator(), two.locator())), InstantSource.system())) {
      register(one, gps, attributes("r", "gps", 1));
      register(two, gps, attributes("r", "gps", 1));
      await().atMost(PATIENCE).until(() -> team.registrarCount() == 2);
      assertThat(team.findFirst(query, PATIENCE)).isPresent();
      one.close();
      await().atMost(PATIENCE).until(() -> team.registrarCount() == 1);
      assertThat(team.find(query)).singleElement().matches(listing -> !listing.stale());
      two.close();
      await().atMost(PATIENCE).until(() -> team.find(query).get(0).stale());
      assertThat(team.find(query)).hasSize(1);
    }
  }

  @Test
  void findsARestartedLookupServiceWithinFiveSeconds() throws Exception {
    EmbeddedReggie first = reggies.get(0);
    int port = first.port();
    ListedGps gps = list("r", "gps", 1);
    ModuleQuery<GPSSensor> query = ModuleQuery.of(GPSSensor.class);
    try (StallProbe probe = StallProbe.start()) {
      first.close();
      StallProbe.Stopwatch closed = probe.stopwatch();
      await()
          .pollInterval(Duration.ofMillis(20))
          .atMost(PATIENCE)
          .until(() -> directory.find(query).get(0).stale());
      Timing stale = closed.stop();
      System.out.printf("stale after the end of the lookup service: %s%n", stale);
      EmbeddedReggie second = start(port);
      register(second, gps, attributes("r", "gps", 1));
      StallProbe.Stopwatch listed = probe.stopwatch();
      await().atMost(PATIENCE).until(() -> !directory.find(query).get(0).stale());
      Timing found = listed.stop();
      assertThat(directory.find(query)).hasSize(1);
      found.requireWithin("finding a restarted lookup service", FOUND);
      stale.requireWithin("being stale after the end of the lookup service", STALE);
    }
  }

  private void showAtTheRegistrar(PersonaAttributes persona) throws Exception {
    JoinAdmin admin = (JoinAdmin) ((Administrable) reggies.get(0).registrar()).getAdmin();
    admin.addLookupAttributes(Entries.toEntries(List.of(persona)));
  }

  @Test
  void readsARobotsPersonaFromItsRegistrar() throws Exception {
    PersonaAttributes persona =
        new PersonaAttributes("atrv1", "scout", List.of("map the field"), List.of());
    showAtTheRegistrar(persona);
    await()
        .atMost(PATIENCE)
        .untilAsserted(
            () ->
                assertThat(directory.personas())
                    .singleElement()
                    .extracting(found -> found.attributes().orElse(null))
                    .isEqualTo(persona));
  }

  @Test
  void aPersonaIsThatOfTheRobotOnItsRegistrarsHost() throws Exception {
    list("atrv1", "gps", 1); // on the registrar's host
    list("gps", List.of(module("atrv1", "gps", "192.0.2.1", Readiness.READY)), Locality.REMOTE);
    showAtTheRegistrar(new PersonaAttributes("atrv1", "scout", List.of(), List.of()));
    await()
        .atMost(PATIENCE)
        .untilAsserted(
            () ->
                assertThat(directory.personas())
                    .extracting(Persona::host, each -> each.attributes().isPresent())
                    .containsExactly(tuple(EmbeddedReggie.HOST, true), tuple("192.0.2.1", false)));
  }

  @Test
  void aLocatorWhereNobodyAnswersHoldsUpNobody() throws Exception {
    int free = FreePorts.allocate();
    EmbeddedReggie reggie = reggies.get(0);
    list("r", "gps", 1);
    try (JiniModuleDirectory both =
        new JiniModuleDirectory(
            settings(List.of("jini://127.0.0.1:" + free, reggie.locator())),
            InstantSource.system())) {
      assertThat(both.find(GPSSensor.class, PATIENCE)).isPresent();
    }
  }

  @Test
  void theFirstLookAwaitsALookupServiceThatWasFoundAndIsBeingRead() throws Exception {
    CountDownLatch read = new CountDownLatch(1);
    list("r", "gps", 1);
    try (JiniModuleDirectory slow = slow(Duration.ofSeconds(30), read)) {
      await().until(() -> slow.registrarCount() == 1);
      CompletableFuture<List<String>> look = firstLook(slow);
      await().during(Duration.ofMillis(200)).atMost(PATIENCE).until(() -> !look.isDone());
      read.countDown();
      assertThat(look.get(30, TimeUnit.SECONDS)).isEmpty();
      assertThat(slow.find(ModuleQuery.of(GPSSensor.class))).hasSize(1);
    }
  }

  @Test
  void theFirstLookDoesNotAwaitALookupServiceThatHasFallenSilent() throws Exception {
    CountDownLatch read = new CountDownLatch(1);
    try (JiniModuleDirectory slow = slow(Duration.ofMillis(300), read)) {
      await().until(() -> slow.registrarCount() == 1);
      assertThat(firstLook(slow).get(30, TimeUnit.SECONDS))
          .containsExactly(reggies.get(0).locator() + "/");
      read.countDown();
    }
  }

  private static CompletableFuture<List<String>> firstLook(JiniModuleDirectory directory) {
    return CompletableFuture.supplyAsync(
        () -> {
          try {
            return directory.awaitFirstRead(Duration.ZERO);
          } catch (InterruptedException e) {
            throw new IllegalStateException(e);
          }
        });
  }

  /** A directory whose reader of the lookup service stands still until it may go on. */
  private JiniModuleDirectory slow(Duration silence, CountDownLatch read) throws Exception {
    InstantSource clock =
        () -> {
          if (Thread.currentThread().getName().startsWith("dfra-registrar-")) {
            try {
              read.await();
            } catch (InterruptedException e) {
              Thread.currentThread().interrupt();
            }
          }
          return Instant.now();
        };
    DirectorySettings usual = settings(List.of(reggies.get(0).locator()));
    return new JiniModuleDirectory(
        new DirectorySettings(
            usual.callbackHost(),
            usual.groups(),
            usual.locators(),
            usual.locatorRetry(),
            usual.heartbeatInterval(),
            silence,
            usual.reconcileInterval(),
            usual.eventLease()),
        clock);
  }

  @Test
  void aLookupServiceCountsItsServicesWithoutReturningThem() throws Exception {
    ServiceTemplate all = new ServiceTemplate(null, null, null);
    ServiceRegistrar registrar = reggies.get(0).registrar();
    int before = registrar.lookup(all, 0).totalMatches;
    list("r", "gps", 1);
    list("r", "compass", 1);
    ServiceMatches counted = registrar.lookup(all, 0);
    assertThat(counted.totalMatches).isEqualTo(before + 2);
    assertThat(counted.items).isNull();
  }

  @Test
  void refusesALocatorThatIsNone() {
    assertThatThrownBy(() -> new JiniModuleDirectory("127.0.0.1", List.of(), List.of("nowhere")))
        .isInstanceOf(IOException.class)
        .hasMessage("the locator \"nowhere\" is not of the form jini://host or jini://host:port");
  }

  @Test
  void leavesOutServicesThatAreNoModulesOfDfra() throws Exception {
    reggies.get(0).register(UUID.randomUUID(), "a text", List.of(), LEASE.toMillis());
    ListedGps nameless = new ListedGps(UUID.randomUUID(), "nameless");
    reggies.get(0).register(nameless.id(), nameless, List.of(), LEASE.toMillis());
    list("r", "gps", 1);
    assertThat(directory.find(ModuleQuery.of(GPSSensor.class)))
        .singleElement()
        .extracting(listing -> listing.attributes(ModuleAttributes.class).orElseThrow().name())
        .isEqualTo("gps");
  }
}
