package org.dfra.secure;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.Serializable;
import java.nio.charset.StandardCharsets;
import java.nio.file.Path;
import java.rmi.MarshalledObject;
import java.time.Clock;
import java.time.Duration;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.concurrent.CopyOnWriteArrayList;
import java.util.stream.Stream;
import net.jini.admin.Administrable;
import net.jini.admin.JoinAdmin;
import net.jini.core.discovery.LookupLocator;
import net.jini.core.entry.Entry;
import net.jini.core.event.EventRegistration;
import net.jini.core.event.RemoteEvent;
import net.jini.core.event.RemoteEventListener;
import net.jini.core.lookup.ServiceEvent;
import net.jini.core.lookup.ServiceID;
import net.jini.core.lookup.ServiceItem;
import net.jini.core.lookup.ServiceMatches;
import net.jini.core.lookup.ServiceRegistrar;
import net.jini.core.lookup.ServiceRegistration;
import net.jini.core.lookup.ServiceTemplate;
import net.jini.jeri.BasicJeriExporter;
import org.awaitility.Awaitility;
import org.dfra.core.policy.BuiltInPolicies;
import org.dfra.core.policy.Policy;
import org.dfra.core.policy.PolicyGuard;
import org.dfra.core.policy.PolicyXml;
import org.dfra.core.policy.method.InterfaceCatalogue;
import org.dfra.lifecycle.Readiness;
import org.dfra.river.bootstrap.EmbeddedRegistrar;
import org.dfra.river.call.DeadlineILFactory;
import org.dfra.river.call.Endpoints;
import org.dfra.river.entry.ModuleEntry;
import org.dfra.river.entry.PersonaEntry;
import org.dfra.river.entry.RecordEntry;
import org.dfra.river.entry.SensorEntry;
import org.dfra.river.identity.CurrentIdentity;
import org.dfra.river.identity.IdentityFolder;
import org.dfra.river.identity.RevokedCertificates;
import org.dfra.river.identity.TeamCredentials;
import org.dfra.river.identity.TeamIdentity;
import org.dfra.river.registrar.RegistrationPolicy;
import org.dfra.security.Decision;
import org.dfra.security.Guard;
import org.junit.jupiter.api.AfterAll;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeAll;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.io.TempDir;

/** What callers see of a robot's lookup service, by every call that reads it, and by its events. */
@Timeout(90)
class HiddenPartsTest {

  private static final String HOST = "127.0.0.1";
  private static final Duration LEASE = Duration.ofSeconds(60);
  private static final Duration PATIENCE = Duration.ofSeconds(20);
  private static final String SECRET = "192.0.2.99";
  private static final String RECORD = "org.dfra.drivers.laser.lms.LmsAttributes";

  /** A service; the interface says what it is. */
  public record Plain(String name) implements Serializable {}

  private static final String OTTO = "otto";

  @TempDir static Path folder;

  private static SecureTeam team;
  private static TeamIdentity observer;
  private static TeamIdentity operator;

  private final PolicyGuard guard = new PolicyGuard(BuiltInPolicies.standard("field"));
  private TeamIdentity robot;
  private EmbeddedRegistrar reggie;
  private String locator;

  @BeforeAll
  static void admit() throws Exception {
    team = new SecureTeam(folder);
    team.init();
    team.admit("robot", "atrv1");
    team.admit("observer", OTTO);
    observer = identity(OTTO, request -> Decision.permit("test"));
    operator = identity(SecureTeam.ANNA, request -> Decision.permit("test"));
  }

  @AfterAll
  static void dismiss() {
    team.close();
  }

  private static TeamIdentity identity(String name, Guard guard) throws Exception {
    TeamCredentials member = IdentityFolder.load(team.security(name));
    return new TeamIdentity(
        new TeamIdentity.Settings(
            member.member(),
            new TeamIdentity.Key(member.privateKey(), List.of(member.chain())),
            Set.of(),
            Set.of(),
            member.authority(),
            new RevokedCertificates(member.authority()),
            guard,
            false),
        Clock.systemUTC());
  }

  @BeforeEach
  void start() throws Exception {
    robot = identity("atrv1", guard);
    RegistrationPolicy owner = new RegistrationPolicy("atrv1", List.of());
    reggie =
        CurrentIdentity.callAs(
            robot, () -> new EmbeddedRegistrar(HOST, 0, List.of(), LEASE, owner, Map.of()).start());
    locator = reggie.locator();
  }

  @AfterEach
  void end() throws Exception {
    reggie.close();
  }

  private ServiceRegistrar registrar() throws Exception {
    return new LookupLocator(locator).getRegistrar();
  }

  private static SensorEntry sensor(String name) {
    SensorEntry entry = new SensorEntry();
    entry.robot = "atrv1";
    entry.name = name;
    entry.host = SECRET;
    entry.driver = "org.dfra.drivers.Secret";
    entry.author = "somebody";
    entry.version = "1";
    entry.state = Readiness.READY;
    entry.created = 1L;
    entry.clients = 3;
    entry.reading = "GpsFix";
    entry.outputs = new ArrayList<>(List.of("GpsFix"));
    return entry;
  }

  private static RecordEntry record() {
    RecordEntry entry = new RecordEntry();
    entry.type = RECORD;
    entry.values = new ArrayList<>(List.of("baud=38400"));
    return entry;
  }

  private ServiceRegistration register(Object service, Entry... entries) throws Exception {
    return CurrentIdentity.callAs(
        robot,
        () -> registrar().register(new ServiceItem(null, service, entries), LEASE.toMillis()));
  }

  private static ServiceTemplate of(Entry... entries) {
    return new ServiceTemplate(null, null, entries);
  }

  private static ModuleEntry named(String name) {
    ModuleEntry entry = new ModuleEntry();
    entry.name = name;
    return entry;
  }

  private static ModuleEntry hostOf(String host) {
    ModuleEntry entry = new ModuleEntry();
    entry.host = host;
    return entry;
  }

  private void follow(String... rules) {
    StringBuilder text =
        new StringBuilder("<policy xmlns=\"urn:dfra:policy:1\" team=\"field\" version=\"");
    text.append(guard.policy().version() + 1).append("\">\n");
    Stream.of(rules).forEach(each -> text.append(each).append('\n'));
    text.append("<permit standing=\"own,member,expired,stranger\"/></policy>");
    Policy policy =
        PolicyXml.read(
            text.toString().getBytes(StandardCharsets.UTF_8), "p", InterfaceCatalogue.builtIn());
    assertThat(guard.replace(policy)).isTrue();
  }

  @Test
  void aStrangerSeesNamesAndStateByTheStandardPolicyAndNoOtherAttribute() throws Exception {
    PersonaEntry persona = new PersonaEntry();
    persona.robot = "atrv1";
    persona.role = "scout";
    register(new Plain("gps"), sensor("gps_front"), record(), persona);
    ServiceMatches found = registrar().lookup(of(named("gps_front")), 8);
    assertThat(found.totalMatches).isEqualTo(1);
    Entry[] entries = found.items[0].attributeSets;
    assertThat(entries).hasSize(2);
    assertThat(entries[0].getClass())
        .as("of a sensor, only this is seen")
        .isEqualTo(ModuleEntry.class);
    ModuleEntry seen = (ModuleEntry) entries[0];
    assertThat(seen.robot).isEqualTo("atrv1");
    assertThat(seen.state).isEqualTo(Readiness.READY);
    assertThat(Arrays.asList(seen.host, seen.driver, seen.created, seen.clients))
        .containsOnlyNulls();
    assertThat(((PersonaEntry) entries[1]).robot).isEqualTo("atrv1");
    assertThat(((PersonaEntry) entries[1]).role).isNull();

    ServiceMatches all =
        CurrentIdentity.callAs(observer, () -> registrar().lookup(of(named("gps_front")), 8));
    assertThat(all.items[0].attributeSets).hasSize(3);
    assertThat(((SensorEntry) all.items[0].attributeSets[0]).host).isEqualTo(SECRET);
  }

  @Test
  void aTemplateIsNoOracleForWhatIsHidden() throws Exception {
    register(new Plain("gps"), sensor("gps_front"), record());
    ServiceRegistrar stranger = registrar();
    List<Entry> guesses = new ArrayList<>(List.of(hostOf(SECRET), new SensorEntry(), record()));
    SensorEntry clients = new SensorEntry();
    clients.clients = 3;
    guesses.add(clients);
    ModuleEntry both = named("gps_front");
    both.host = SECRET;
    guesses.add(both);
    for (Entry guess : guesses) {
      ServiceTemplate asked = of(guess);
      assertThat(stranger.lookup(asked)).as("%s", guess).isNull();
      assertThat(stranger.lookup(asked, 8).totalMatches).isZero();
      assertThat(stranger.lookup(asked, 0).totalMatches).isZero();
      assertThat(stranger.getEntryClasses(asked)).isNull();
      assertThat(stranger.getServiceTypes(asked, "java")).isNull();
      assertThat(stranger.getFieldValues(asked, 0, guess instanceof RecordEntry ? "type" : "name"))
          .isNull();
    }
    assertThat(stranger.lookup(of(named("gps_front"), hostOf(SECRET)))).isNull();
    assertThat(stranger.lookup(of(named("gps_front"), new ModuleEntry()))).isNotNull();
    for (Entry guess : guesses) {
      assertThat((Object) CurrentIdentity.callAs(observer, () -> registrar().lookup(of(guess))))
          .as("%s", guess)
          .isNotNull();
    }
  }

  @Test
  void fieldValuesAndClassesOfEntriesHaveNothingThatIsHidden() throws Exception {
    register(new Plain("gps"), sensor("gps_front"), record());
    ServiceRegistrar stranger = registrar();
    ServiceTemplate modules = of(new ModuleEntry());
    assertThat(stranger.getFieldValues(modules, 0, "host")).containsOnlyNulls();
    assertThat(stranger.getFieldValues(modules, 0, "name")).containsExactly("gps_front");
    assertThat(stranger.getFieldValues(of(new RecordEntry()), 0, "type")).isNull();
    assertThat(stranger.getFieldValues(of(new SensorEntry()), 0, "host")).isNull();
    assertThat(stranger.getEntryClasses(of())).containsExactly(ModuleEntry.class);
    assertThat(
            stranger.getEntryClasses(new ServiceTemplate(null, new Class<?>[] {Plain.class}, null)))
        .containsExactly(ModuleEntry.class);
    assertThat(
            CurrentIdentity.callAs(operator, () -> registrar().getFieldValues(modules, 0, "host")))
        .containsExactly(SECRET);
  }

  @Test
  void aHiddenServiceIsMissingFromAnswersCountsAndTypes() throws Exception {
    follow("<hide role=\"observer\" object=\"secret_*\"/>");
    ServiceRegistration secret = register(new Plain("one"), sensor("secret_gps"));
    register(new Plain("two"), sensor("gps_front"));
    CurrentIdentity.callAs(
        observer,
        () -> {
          ServiceRegistrar seen = registrar();
          ServiceTemplate plain = new ServiceTemplate(null, new Class<?>[] {Plain.class}, null);
          assertThat(seen.lookup(plain, 8).totalMatches).isEqualTo(1);
          assertThat(seen.lookup(plain, 0).totalMatches).isEqualTo(1);
          assertThat(seen.lookup(plain)).isEqualTo(new Plain("two"));
          ServiceID id = secret.getServiceID();
          assertThat(seen.lookup(new ServiceTemplate(id, null, null))).isNull();
          assertThat(seen.lookup(new ServiceTemplate(id, null, null), 1).totalMatches).isZero();
          assertThat(seen.getServiceTypes(new ServiceTemplate(id, null, null), null)).isNull();
          assertThat(seen.getFieldValues(of(new ModuleEntry()), 0, "name"))
              .containsExactly("gps_front");
          return null;
        });
    CurrentIdentity.callAs(
        operator,
        () -> {
          assertThat(
                  registrar()
                      .lookup(new ServiceTemplate(secret.getServiceID(), null, null))
                      .getClass())
              .isEqualTo(Plain.class);
          return null;
        });
  }

  /** A listener in the process of a member. */
  private static final class Listener implements RemoteEventListener, AutoCloseable {

    final List<ServiceEvent> events = new CopyOnWriteArrayList<>();
    private final BasicJeriExporter exporter =
        new BasicJeriExporter(Endpoints.tcp(HOST, 0), new DeadlineILFactory(), false, true);

    RemoteEventListener export() throws Exception {
      return (RemoteEventListener) exporter.export(this);
    }

    @Override
    public void notify(RemoteEvent event) {
      events.add((ServiceEvent) event);
    }

    ServiceEvent await(int count) {
      Awaitility.await()
          .atMost(PATIENCE)
          .untilAsserted(
              () ->
                  assertThat(events)
                      .extracting(
                          each ->
                              each.getServiceID()
                                  + " "
                                  + each.getTransition()
                                  + " "
                                  + each.getSequenceNumber())
                      .hasSizeGreaterThanOrEqualTo(count));
      return events.get(count - 1);
    }

    @Override
    public void close() {
      boolean unused = exporter.unexport(true);
    }
  }

  private static final int ALL =
      ServiceRegistrar.TRANSITION_MATCH_MATCH
          | ServiceRegistrar.TRANSITION_MATCH_NOMATCH
          | ServiceRegistrar.TRANSITION_NOMATCH_MATCH;

  private long listen(ServiceTemplate template, int transitions, RemoteEventListener stub)
      throws Exception {
    EventRegistration made =
        registrar()
            .notify(template, transitions, stub, (MarshalledObject<?>) null, LEASE.toMillis());
    return made.getSequenceNumber();
  }

  private void change(ServiceRegistration of, Entry template, Entry change) throws Exception {
    CurrentIdentity.callAs(
        robot,
        () -> {
          of.modifyAttributes(new Entry[] {template}, new Entry[] {change});
          return null;
        });
  }

  @Test
  void eventsHaveNothingThatIsHiddenAndNoGapsForWhatIsNotSent() throws Exception {
    follow(
        "<hide role=\"observer\" object=\"secret_*\"/>",
        "<hide role=\"observer\" entry=\"module.host,module.clients,sensor\"/>");
    try (Listener seen = CurrentIdentity.callAs(observer, Listener::new);
        Listener oracle = CurrentIdentity.callAs(observer, Listener::new)) {
      ServiceRegistration before = register(new Plain("before"), sensor("before"));
      long base = CurrentIdentity.callAs(observer, () -> listen(of(), ALL, seen.export()));
      CurrentIdentity.callAs(observer, () -> listen(of(hostOf(SECRET)), ALL, oracle.export()));
      ServiceRegistration secret = register(new Plain("secret"), sensor("secret_gps"));
      ServiceRegistration gps = register(new Plain("gps"), sensor("gps_front"));
      ServiceEvent added = seen.await(1);
      assertThat(added.getServiceID()).isEqualTo(gps.getServiceID());
      assertThat(added.getTransition()).isEqualTo(ServiceRegistrar.TRANSITION_NOMATCH_MATCH);
      assertThat(added.getSequenceNumber()).isEqualTo(base + 1);
      ModuleEntry entry = (ModuleEntry) added.getServiceItem().attributeSets[0];
      assertThat(entry.name).isEqualTo("gps_front");
      assertThat(entry.host).isNull();
      assertThat(entry.getClass()).isNotEqualTo(SensorEntry.class);

      ModuleEntry more = new ModuleEntry();
      more.clients = 4;
      change(gps, new ModuleEntry(), more); // what is hidden
      change(secret, new ModuleEntry(), more);
      ModuleEntry failed = new ModuleEntry();
      failed.state = Readiness.FAILED;
      change(gps, new ModuleEntry(), failed);
      ServiceEvent changed = seen.await(2);
      assertThat(changed.getTransition()).isEqualTo(ServiceRegistrar.TRANSITION_MATCH_MATCH);
      assertThat(((ModuleEntry) changed.getServiceItem().attributeSets[0]).state)
          .isEqualTo(Readiness.FAILED);
      assertThat(changed.getSequenceNumber()).isEqualTo(base + 2);

      for (ServiceRegistration each : List.of(secret, gps, before)) {
        CurrentIdentity.callAs(
            robot,
            () -> {
              each.getLease().cancel();
              return null;
            });
      }
      ServiceEvent last = seen.await(4);
      assertThat(last.getSequenceNumber()).isEqualTo(base + 4);
      assertThat(seen.events)
          .extracting(ServiceEvent::getServiceID)
          .containsExactly(
              gps.getServiceID(), gps.getServiceID(), gps.getServiceID(), before.getServiceID());
      assertThat(last.getTransition()).isEqualTo(ServiceRegistrar.TRANSITION_MATCH_NOMATCH);
      assertThat(last.getServiceItem()).isNull();
      assertThat(oracle.events).as("events of a template that asks for a hidden value").isEmpty();
    }
  }

  @Test
  void aPolicyThatHidesLaterCountsForListenersThatAreThere() throws Exception {
    follow();
    try (Listener seen = CurrentIdentity.callAs(observer, Listener::new)) {
      CurrentIdentity.callAs(observer, () -> listen(of(), ALL, seen.export()));
      ServiceRegistration gps = register(new Plain("gps"), sensor("gps_front"));
      ServiceEvent whole = seen.await(1);
      assertThat(((ModuleEntry) whole.getServiceItem().attributeSets[0]).host).isEqualTo(SECRET);
      follow("<hide role=\"observer\" entry=\"module.host\"/>");
      ModuleEntry failed = new ModuleEntry();
      failed.state = Readiness.FAILED;
      change(gps, new ModuleEntry(), failed);
      ServiceEvent changed = seen.await(2);
      ModuleEntry entry = (ModuleEntry) changed.getServiceItem().attributeSets[0];
      assertThat(entry.state).isEqualTo(Readiness.FAILED);
      assertThat(entry.host).isNull();
      assertThat(((SensorEntry) entry).reading).isEqualTo("GpsFix");
    }
  }

  @Test
  void theAttributesOfTheLookupServiceItselfAreHiddenToo() throws Exception {
    follow("<hide standing=\"stranger\" entry=\"*\"/>");
    JoinAdmin seen = (JoinAdmin) ((Administrable) registrar()).getAdmin();
    assertThat(seen.getLookupAttributes()).isEmpty();
    Entry[] own =
        CurrentIdentity.callAs(
            robot,
            () -> ((JoinAdmin) ((Administrable) registrar()).getAdmin()).getLookupAttributes());
    assertThat(own).hasSizeGreaterThanOrEqualTo(2);
  }
}
