package org.dfra.attack.registrar;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.lang.reflect.Array;
import java.lang.reflect.Constructor;
import java.lang.reflect.Field;
import java.lang.reflect.InvocationTargetException;
import java.lang.reflect.Method;
import java.time.Duration;
import java.util.Arrays;
import java.util.List;
import java.util.Map;
import net.jini.core.entry.Entry;
import net.jini.core.lookup.ServiceID;
import net.jini.core.lookup.ServiceItem;
import net.jini.core.lookup.ServiceMatches;
import net.jini.core.lookup.ServiceRegistrar;
import net.jini.core.lookup.ServiceRegistration;
import net.jini.core.lookup.ServiceTemplate;
import net.jini.id.Uuid;
import net.jini.lookup.entry.Name;
import org.dfra.attack.kit.AttackHosts;
import org.dfra.attack.kit.Fakes;
import org.dfra.benchmarks.attack.SourceBoundProxies;
import org.dfra.benchmarks.attack.SourceSockets;
import org.dfra.directory.RegistrationRefusedException;
import org.dfra.river.bootstrap.EmbeddedRegistrar;
import org.dfra.river.entry.ModuleEntry;
import org.dfra.river.registrar.RegistrationPolicy;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;

/**
 * A stranger calls the robot's reggie with what River's own client never sends. Each of these calls
 * ended the lookup service for everybody, until its process was restarted.
 */
@Timeout(60)
class MalformedRegistrationTest {

  private static final String REGGIE = "com.sun.jini.reggie.";
  private static final Duration LEASE = Duration.ofSeconds(60);

  /** Leases in one call; their cost is the square of it. */
  private static final int MANY = 50_000;

  private final AttackHosts hosts = AttackHosts.assumed();
  private EmbeddedRegistrar reggie;
  private ServiceRegistrar own;
  private ServiceRegistrar stranger;

  @BeforeEach
  void start() throws Exception {
    RegistrationPolicy policy = new RegistrationPolicy("eta", List.of());
    reggie = new EmbeddedRegistrar(hosts.robot(), 0, List.of(), LEASE, policy, Map.of()).start();
    own = reggie.registrar();
    stranger = SourceBoundProxies.of(own, SourceSockets.from(hosts.attacker()));
  }

  @AfterEach
  void end() throws Exception {
    if (reggie != null) {
      reggie.close();
    }
  }

  private static Class<?> type(String name) throws ClassNotFoundException {
    return Class.forName(REGGIE + name);
  }

  private static Field field(Object of, String name) throws NoSuchFieldException {
    Class<?> type = of.getClass();
    while (Arrays.stream(type.getDeclaredFields()).noneMatch(f -> f.getName().equals(name))) {
      type = type.getSuperclass();
      if (type == null) {
        throw new NoSuchFieldException(name);
      }
    }
    Field field = type.getDeclaredField(name);
    field.setAccessible(true);
    return field;
  }

  private static Object get(Object of, String name) throws ReflectiveOperationException {
    return field(of, name).get(of);
  }

  private static void set(Object of, String name, Object value)
      throws ReflectiveOperationException {
    field(of, name).set(of, value);
  }

  private static Object make(String name, Class<?> from, Object argument)
      throws ReflectiveOperationException {
    Constructor<?> constructor = type(name).getDeclaredConstructor(from);
    constructor.setAccessible(true);
    return constructor.newInstance(argument);
  }

  private static Object item(Object service, Entry... entries) throws ReflectiveOperationException {
    return make("Item", ServiceItem.class, new ServiceItem(null, service, entries));
  }

  private static Object entry(Entry entry) throws ReflectiveOperationException {
    return make("EntryRep", Entry.class, entry);
  }

  /** Reggie's own descriptors are shared by everything here; this one is nobody else's. */
  private static Object ownDescriptor(Object entry) throws ReflectiveOperationException {
    Object shared = get(entry, "eclass");
    Constructor<?> constructor = shared.getClass().getDeclaredConstructor(shared.getClass());
    constructor.setAccessible(true);
    Object copy = constructor.newInstance(shared);
    set(copy, "superclass", get(shared, "superclass"));
    set(copy, "numFields", get(shared, "numFields"));
    set(entry, "eclass", copy);
    return copy;
  }

  private static Object typeTemplate(Class<?> type) throws ReflectiveOperationException {
    return make(
        "Template", ServiceTemplate.class, new ServiceTemplate(null, new Class<?>[] {type}, null));
  }

  /** Calls reggie as a client's smart proxy does. */
  private static Object call(ServiceRegistrar registrar, String method, Object... args)
      throws Exception {
    Object server = get(registrar, "server");
    Method called =
        Arrays.stream(type("Registrar").getMethods())
            .filter(each -> each.getName().equals(method))
            .filter(each -> each.getParameterCount() == args.length)
            .findFirst()
            .orElseThrow();
    called.setAccessible(true);
    try {
      return called.invoke(server, args);
    } catch (InvocationTargetException e) {
      if (e.getCause() instanceof Exception cause) {
        throw cause;
      }
      throw e;
    }
  }

  private void assertMalformed(String method, Object... args) throws Exception {
    assertThatThrownBy(() -> call(stranger, method, args))
        .isInstanceOf(IllegalArgumentException.class)
        .hasMessageContaining("send what River's own client does");
    assertServes();
  }

  /** The robot's module registers, is found, listened for, changed and ended. */
  private void assertServes() throws Exception {
    ServiceRegistration drive = Fakes.register(own, null, "honest", Fakes.module("eta", "drive"));
    ModuleEntry wanted = new ModuleEntry();
    wanted.robot = "eta";
    ServiceMatches found =
        own.lookup(
            new ServiceTemplate(null, new Class<?>[] {String.class}, new Entry[] {wanted}), 10);
    assertThat(found.items).extracting(each -> each.serviceID).contains(drive.getServiceID());
    assertThat(own.lookup(new ServiceTemplate(null, null, null), 100).totalMatches).isPositive();
    assertThat(Fakes.listen(own)).as("the number of an event").isNotNegative();
    drive.addAttributes(new Entry[] {new Name("x")});
    drive.getLease().cancel();
  }

  @Test
  void aServiceWithoutType() throws Exception {
    Object item = item("fake");
    set(item, "serviceID", new ServiceID(6, 6));
    set(item, "serviceType", null);
    assertMalformed("register", item, LEASE.toMillis());
  }

  @Test
  void anEntryThatIsMissing() throws Exception {
    Object item = item("fake", new Name("x"));
    Array.set(get(item, "attributeSets"), 0, null);
    assertMalformed("register", item, LEASE.toMillis());
  }

  @Test
  void aListenerForATypeThatIsMissing() throws Exception {
    Object template = typeTemplate(String.class);
    Array.set(get(template, "serviceTypes"), 0, null);
    assertMalformed("notify", template, 1, Fakes.deaf(), null, LEASE.toMillis());
  }

  @Test
  void aClassOfEntriesThatExtendsItself() throws Exception {
    Object item = item("fake", new Name("x"));
    Object descriptor = ownDescriptor(Array.get(get(item, "attributeSets"), 0));
    set(descriptor, "superclass", descriptor);
    assertThatThrownBy(() -> call(stranger, "register", item, LEASE.toMillis()))
        .isInstanceOf(IllegalArgumentException.class)
        .hasMessageContaining("superclasses");
    assertServes();
  }

  @Test
  void aFieldThatIsNoValue() throws Exception {
    Object item = item("fake", new Name("x"));
    Object entry = Array.get(get(item, "attributeSets"), 0);
    Array.set(get(entry, "fields"), 0, new ServiceID(6, 6));
    assertMalformed("register", item, LEASE.toMillis());
  }

  @Test
  void aFalseModuleEntryBeforeTheFirstTrueOne() throws Exception {
    Object item = item("fake", new ModuleEntry());
    Object entry = Array.get(get(item, "attributeSets"), 0);
    Object descriptor = ownDescriptor(entry);
    set(descriptor, "numFields", 1);
    set(entry, "fields", new Object[] {"x"});
    assertMalformed("register", item, LEASE.toMillis());
  }

  @Test
  void manyLeasesAtOnce() throws Exception {
    Object[] registrations = new Object[MANY];
    Arrays.fill(registrations, 1L);
    assertThatThrownBy(() -> call(stranger, "cancelLeases", registrations, new Uuid[MANY]))
        .isInstanceOf(IllegalArgumentException.class)
        .hasMessageContaining(MANY + " leases > 4096 allowed");
    assertServes();
  }

  @Test
  void anotherNameForTheEntryThatNamesTheRobot() throws Exception {
    ModuleEntry claim = Fakes.module("eta", "drive");
    Object item = item("fake", claim);
    Object descriptor = ownDescriptor(Array.get(get(item, "attributeSets"), 0));
    set(descriptor, "superclass", get(entry(claim), "eclass"));
    set(descriptor, "hash", 66L);
    set(descriptor, "name", Name.class.getName());
    assertThatThrownBy(() -> call(stranger, "register", item, LEASE.toMillis()))
        .isInstanceOf(RegistrationRefusedException.class)
        .hasMessageContaining("robot eta");
  }

  @Test
  void anotherNameForAChangeThatNamesTheRobot() throws Exception {
    ServiceRegistration fake =
        Fakes.register(stranger, null, "fake", Fakes.module("theta", "drive"));
    ModuleEntry change = new ModuleEntry();
    change.robot = "eta";
    Object changed = entry(change);
    set(ownDescriptor(changed), "name", Name.class.getName());
    Object all = entry(new ModuleEntry());
    assertThatThrownBy(
            () ->
                call(
                    stranger,
                    "modifyAttributes",
                    fake.getServiceID(),
                    get(fake.getLease(), "leaseID"),
                    array(all),
                    array(changed)))
        .isInstanceOf(RegistrationRefusedException.class)
        .hasMessageContaining("robot eta");
  }

  private static Object array(Object entry) throws ReflectiveOperationException {
    Object array = Array.newInstance(type("EntryRep"), 1);
    Array.set(array, 0, entry);
    return array;
  }

  @Test
  void aServiceThatIsTooLargeAtOnceOrGrowsSo() throws Exception {
    String large = "x".repeat(70_000);
    assertThatThrownBy(() -> Fakes.register(stranger, null, "fake", new Name(large)))
        .isInstanceOf(RegistrationRefusedException.class)
        .hasMessageContaining("bytes > 65536 allowed");
    ServiceRegistration fake =
        SourceBoundProxies.of(
            Fakes.register(stranger, null, "fake", new Name("x")), hosts.attackerSockets());
    String part = "y".repeat(19_000);
    for (int i = 0; i < 3; i++) {
      fake.addAttributes(new Entry[] {new Name(i + part)});
    }
    assertThatThrownBy(() -> fake.addAttributes(new Entry[] {new Name("3" + part)}))
        .isInstanceOf(RegistrationRefusedException.class)
        .hasMessageContaining("bytes > 65536 allowed");
    Fakes.register(own, null, "own", new Name(large)).getLease().cancel();
  }
}
