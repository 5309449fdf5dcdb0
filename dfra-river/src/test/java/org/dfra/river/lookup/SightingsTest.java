package org.dfra.river.lookup;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.lang.reflect.Proxy;
import java.time.Instant;
import java.time.InstantSource;
import java.util.List;
import java.util.UUID;
import net.jini.core.lookup.ServiceID;
import net.jini.core.lookup.ServiceItem;
import org.dfra.core.directory.CachedModuleDirectory;
import org.dfra.core.directory.ModuleTable;
import org.dfra.directory.Locality;
import org.dfra.directory.ModuleListing;
import org.dfra.directory.ModuleQuery;
import org.dfra.directory.Persona;
import org.dfra.module.Identification;
import org.dfra.module.Module;
import org.dfra.module.Readiness;
import org.dfra.persona.ModuleAttributes;
import org.dfra.persona.PersonaAttributes;
import org.dfra.river.discovery.FakeRegistrar;
import org.dfra.river.discovery.LocatedRegistrar;
import org.dfra.river.entry.Entries;
import org.dfra.river.proxy.ModuleProxy;
import org.dfra.river.remote.RemoteModule;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;

/** What counts where several lookup services list different modules under one service ID. */
class SightingsTest {

  private static final ServiceID ID = new ServiceID(0, 99);
  private static final Instant VOUCHED = Instant.parse("2026-11-21T12:00:00Z");

  private final Directory directory = new Directory();
  private final Sightings sightings =
      new Sightings(directory.known(), (id, attributes) -> Locality.REMOTE);
  private final RemoteModule server = server();
  private final RemoteModule otherServer = server();
  private LocatedRegistrar honest;
  private LocatedRegistrar stranger;

  private static final class Directory extends CachedModuleDirectory {

    Directory() {
      super(InstantSource.system());
    }

    ModuleTable known() {
      return table();
    }
  }

  /** A proxy as modules have it: equal to every other one of its service ID. */
  private static final class Gps extends ModuleProxy<Module> {

    private static final long serialVersionUID = 1L;

    Gps(RemoteModule server) {
      super(
          Module.class,
          server,
          Sightings.uuid(ID),
          new Identification("atrv1", "gps", "a receiver", "DFRA", "1.0"));
    }
  }

  @BeforeEach
  void find() throws IOException {
    honest = new FakeRegistrar(7, "field").at("127.0.0.1", 4160);
    stranger = new FakeRegistrar(7, "a copy").at("127.0.0.66", 4160);
  }

  @AfterEach
  void close() {
    directory.close();
  }

  private static RemoteModule server() {
    return (RemoteModule)
        Proxy.newProxyInstance(
            RemoteModule.class.getClassLoader(),
            new Class<?>[] {RemoteModule.class},
            (proxy, method, args) ->
                switch (method.getName()) {
                  case "equals" -> proxy == args[0];
                  case "hashCode" -> System.identityHashCode(proxy);
                  default -> throw new AssertionError(method + " is a call");
                });
  }

  private static ServiceItem item(RemoteModule server, String host) {
    ModuleAttributes attributes =
        new ModuleAttributes(
            "atrv1",
            "gps",
            "org.example.Driver",
            host,
            "DFRA",
            "1.0",
            Readiness.READY,
            VOUCHED,
            null,
            0);
    return new ServiceItem(
        ID, server == null ? null : new Gps(server), Entries.of(List.of(attributes)));
  }

  private ServiceItem own() {
    return item(server, "127.0.0.1");
  }

  private ServiceItem fake() {
    return item(otherServer, "127.0.0.66");
  }

  private List<ModuleListing<Module>> listings() {
    return directory.find(ModuleQuery.of(Module.class));
  }

  private void assertShows(RemoteModule which, boolean isStale) {
    assertThat(listings())
        .singleElement()
        .satisfies(
            each -> {
              assertThat(((ModuleProxy<?>) each.module()).server() == which).isTrue();
              assertThat(each.stale()).isEqualTo(isStale);
            });
  }

  @Test
  void theFirstWithinReachCountsAndAnotherChangesNothing() {
    sightings.all(honest, List.of(own()));
    sightings.all(stranger, List.of(fake()));
    assertShows(server, false);
    sightings.seen(stranger, fake());
    assertShows(server, false);
    sightings.gone(stranger, Sightings.uuid(ID));
    assertShows(server, false);
    sightings.seen(stranger, fake());
    sightings.lost(stranger, VOUCHED);
    assertShows(server, false);
  }

  @Test
  void theNextOneCountsWhenTheFirstIsOutOfReachOrLetsGo() {
    sightings.all(honest, List.of(own()));
    sightings.all(stranger, List.of(fake()));
    sightings.lost(honest, VOUCHED);
    assertShows(otherServer, false);
    sightings.all(honest, List.of(own()));
    assertShows(otherServer, false);
    sightings.gone(stranger, Sightings.uuid(ID));
    assertShows(server, false);
    sightings.gone(honest, Sightings.uuid(ID));
    assertThat(listings()).isEmpty();
  }

  @Test
  void aStrangerThatGoesDoesNotRemoveWhatOneOutOfReachLists() {
    sightings.all(honest, List.of(own()));
    sightings.lost(honest, VOUCHED);
    assertShows(server, true);
    sightings.all(stranger, List.of(fake()));
    sightings.all(stranger, List.of());
    assertShows(server, true);
    assertThat(listings().get(0).confirmed()).isEqualTo(VOUCHED);
    sightings.all(honest, List.of());
    assertThat(listings()).isEmpty();
  }

  @Test
  void aModuleThatLeavesOneWithinReachIsGoneThoughAnotherIsOutOfReach() {
    sightings.all(honest, List.of(own()));
    sightings.all(stranger, List.of(own()));
    sightings.lost(honest, VOUCHED);
    sightings.gone(stranger, Sightings.uuid(ID));
    assertThat(listings()).isEmpty();
  }

  @Test
  void aProxyThatCannotBeReadHidesNoneThatCan() {
    ServiceItem unreadable = item(null, "127.0.0.66");
    sightings.all(stranger, List.of(unreadable));
    assertThat(sightings.unreadable()).hasSize(1);
    sightings.all(honest, List.of(own()));
    assertShows(server, false);
    assertThat(sightings.unreadable()).isEmpty();
    sightings.lost(honest, VOUCHED);
    assertShows(server, true);
    assertThat(sightings.unreadable()).hasSize(1);
  }

  @Test
  void aConflictIsReportedWhileItLasts() {
    sightings.all(honest, List.of(own()));
    assertThat(sightings.conflicts()).isEmpty();
    sightings.all(stranger, List.of(fake()));
    assertThat(sightings.conflicts())
        .containsExactly(
            new ModuleConflict(
                "atrv1/gps",
                Sightings.uuid(ID).toString(),
                "127.0.0.1:4160",
                List.of("127.0.0.66:4160")));
    sightings.lost(stranger, VOUCHED);
    assertThat(sightings.conflicts()).isEmpty();
  }

  @Test
  void oneModuleInTwoLookupServicesIsNoConflict() {
    sightings.all(honest, List.of(own()));
    sightings.all(stranger, List.of(own()));
    assertThat(sightings.conflicts()).isEmpty();
  }

  @Test
  void aRestartedLookupServiceTakesThePlaceOfItsFormerSelf() throws Exception {
    sightings.all(honest, List.of(own()));
    sightings.lost(honest, VOUCHED);
    LocatedRegistrar restarted = new FakeRegistrar(7, "restarted").at("127.0.0.1", 4161);
    sightings.all(restarted, List.of());
    assertThat(listings()).isEmpty();
  }

  @Test
  void aRobotIsWhereItsOwnLookupServiceIsThoughACopyClaimsItToo() {
    UUID registrar = Sightings.uuid(honest.getServiceID());
    PersonaAttributes persona = new PersonaAttributes("atrv1", "scout", List.of(), List.of());
    ServiceItem robot =
        new ServiceItem(honest.getServiceID(), "a registrar", Entries.of(List.of(persona)));
    sightings.runsAt(honest, "192.0.2.1");
    sightings.all(honest, List.of(robot));
    sightings.runsAt(stranger, "192.0.2.66");
    sightings.all(stranger, List.of(robot));
    assertThat(directory.personas()).extracting(Persona::host).containsExactly("192.0.2.1");
    sightings.gone(stranger, registrar);
    assertThat(directory.personas()).extracting(Persona::host).containsExactly("192.0.2.1");
  }
}
