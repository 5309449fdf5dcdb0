package org.dfra.river.filter;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.io.ByteArrayInputStream;
import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.io.ObjectInputStream;
import java.io.ObjectOutputStream;
import java.io.Serializable;
import java.io.UncheckedIOException;
import java.lang.reflect.Method;
import java.net.URISyntaxException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.rmi.Remote;
import java.time.Duration;
import java.time.Instant;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.Collection;
import java.util.EnumSet;
import java.util.HashMap;
import java.util.HashSet;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.TreeSet;
import java.util.UUID;
import java.util.stream.Stream;
import net.jini.core.discovery.LookupLocator;
import net.jini.core.entry.Entry;
import net.jini.id.UuidFactory;
import net.jini.io.MarshalOutputStream;
import net.jini.jeri.BasicObjectEndpoint;
import net.jini.jeri.tcp.TcpEndpoint;
import net.jini.lookup.entry.Name;
import org.dfra.behavior.HomeGoal;
import org.dfra.behavior.LegGoal;
import org.dfra.behavior.PathGoal;
import org.dfra.behavior.RasterGoal;
import org.dfra.event.Delivery;
import org.dfra.event.DeliveryPolicy;
import org.dfra.event.ModuleEvent;
import org.dfra.event.ModuleListener;
import org.dfra.flow.effector.CommandKey;
import org.dfra.flow.effector.DriveCommand;
import org.dfra.flow.effector.FlightCommand;
import org.dfra.flow.effector.PanTiltCommand;
import org.dfra.flow.perceptual.Clearance;
import org.dfra.flow.perceptual.HeadingPercept;
import org.dfra.geometry.GeoPosition;
import org.dfra.geometry.Leg;
import org.dfra.lease.LeaseHandle;
import org.dfra.module.LogLevel;
import org.dfra.river.call.DeadlineILFactory;
import org.dfra.river.remote.RemoteDiagnostics;
import org.dfra.river.remote.RemoteModule;
import org.junit.jupiter.api.Test;

class MethodTypesTest {

  private static final AllowedTypes CONFIGURED = new AllowedTypes(List.of());

  /** Parameters of all kinds. */
  interface Kinds extends Remote {
    void closed(Shape shape, List<Part> parts, Map<String, int[]> numbers, Mode[] modes);

    void plain(Duration duration, String text, UUID id, int number);

    void any(Object value);

    void inside(AnyValue loose);

    void replaced(Replaced value);

    void wild(Collection<? extends Shape> shapes);

    void unfinished(Unfinished value);
  }

  /** All its kinds are known. */
  sealed interface Shape extends Serializable permits Circle, Square {}

  record Circle(double radius, Part part) implements Shape {}

  record Square(Mode mode) implements Shape {}

  record Part(String name, Instant made) implements Serializable {}

  record Other(String name) implements Serializable {}

  record AnyValue(Object value) implements Serializable {}

  enum Mode {
    ON {},
    OFF
  }

  static final class Replaced implements Serializable {
    private static final long serialVersionUID = 1L;

    Object writeReplace() {
      return "another";
    }
  }

  /** Anybody may extend it. */
  static class Unfinished implements Serializable {
    private static final long serialVersionUID = 1L;
  }

  @Test
  void closedParametersTakeWhatTheyDeclare() throws Exception {
    Object[] honest = {
      new Circle(1, new Part("a", Instant.EPOCH)),
      List.of(new Part("b", Instant.EPOCH)),
      new HashMap<>(Map.of("c", new int[] {1})),
      new Mode[] {Mode.ON, Mode.OFF}
    };
    assertThat(types("closed").acceptsUndeclaredTypes()).isFalse();
    assertThat(call(method("closed"), honest)).hasSize(honest.length);
    assertThat(call(method("closed"), new Square(Mode.ON))).hasSize(1);
    assertThat(call(method("wild"), List.of(new Square(Mode.OFF)))).hasSize(1);
    assertThat(call(method("plain"), Duration.ZERO, "x", UUID.randomUUID(), Integer.valueOf(1)))
        .hasSize(4);
  }

  @Test
  void closedParametersTakeNothingElse() {
    for (Object foreign :
        List.of(new Other("a"), new net.jini.core.lookup.ServiceID(1, 2), new Throwable())) {
      assertThatThrownBy(() -> call(method("closed"), foreign))
          .cause()
          .isInstanceOf(RefusedDataException.class)
          .hasMessage(
              "refused to read class "
                  + foreign.getClass().getName()
                  + ": no argument of Kinds.closed holds one; call it as its interface declares"
                  + " it");
    }
    for (Object foreign :
        List.of(new HashSet<>(Set.of("a")), List.of("a"), new Object[1], Mode.ON)) {
      assertThatThrownBy(() -> call(method("plain"), foreign))
          .as(foreign.getClass().getName())
          .cause()
          .isInstanceOf(RefusedDataException.class)
          .hasMessageContaining("no argument of Kinds.plain holds one");
    }
  }

  @Test
  void parametersWithKindsUnknownTakeAllThatIsAllowed() throws Exception {
    for (String name : List.of("any", "inside", "replaced", "unfinished")) {
      assertThat(types(name).acceptsUndeclaredTypes()).as(name).isTrue();
      assertThat(call(method(name), new Other("a"), Set.of("b"))).hasSize(2);
      assertThatThrownBy(
              () -> call(method(name), new javax.management.BadAttributeValueExpException("x")))
          .cause()
          .isInstanceOf(RefusedDataException.class);
    }
  }

  @Test
  void nothingIsReadBeforeTheMethodIsKnown() throws Exception {
    ByteArrayOutputStream bytes = new ByteArrayOutputStream();
    try (ObjectOutputStream out = new ObjectOutputStream(bytes)) {
      out.writeInt(1);
      out.writeObject(UUID.randomUUID());
    }
    try (ObjectInputStream in =
        new ObjectInputStream(new ByteArrayInputStream(bytes.toByteArray()))) {
      FilteredInvocationDispatcher.CallFilter filter =
          new FilteredInvocationDispatcher.CallFilter(SerialLimits.CALL);
      in.setObjectInputFilter(filter);
      assertThat(in.readInt()).isEqualTo(1);
      assertThatThrownBy(in::readObject)
          .cause()
          .hasMessageContaining("class java.util.UUID before the method that is called");
      filter.narrow(types("any"));
      assertThatThrownBy(() -> filter.narrow(types("any")))
          .isInstanceOf(IllegalStateException.class);
    }
  }

  @Test
  void everyRemoteInterfaceTakesWhatIsSentToIt() throws Exception {
    Map<Class<?>, List<Object>> samples = samples();
    Set<String> missing = new TreeSet<>();
    int calls = 0;
    for (Class<?> remote : remoteInterfaces()) {
      for (Method method : remote.getMethods()) {
        for (Class<?> parameter : method.getParameterTypes()) {
          if (parameter.isPrimitive()) {
            continue;
          }
          List<Object> sent = samples.get(parameter);
          if (sent == null) {
            missing.add(parameter.getName() + " of " + method);
            continue;
          }
          assertThat(call(method, sent.toArray())).as("%s", method).hasSize(sent.size());
          calls += sent.size();
        }
      }
    }
    assertThat(missing).as("parameters without a sample; add some").isEmpty();
    assertThat(calls).isGreaterThan(100);
  }

  @Test
  void methodsOfModulesAreClosedWhereTheyCanBe() throws Exception {
    List<Method> closed =
        List.of(
            RemoteModule.class.getMethod("acquireLease", Duration.class),
            RemoteModule.class.getMethod("awaitReadiness", Duration.class),
            RemoteModule.class.getMethod("setParameter", String.class, String.class),
            RemoteDiagnostics.class.getMethod(
                "startDiagnostic", RemoteDiagnostics.DiagnosticType.class, String.class));
    for (Method method : closed) {
      assertThat(MethodTypes.of(method, CONFIGURED).acceptsUndeclaredTypes())
          .as("%s", method)
          .isFalse();
    }
  }

  /** What DFRA's own programs send, for each type of a parameter. */
  private static Map<Class<?>, List<Object>> samples() throws Exception {
    GeoPosition place = new GeoPosition(50, 8, 100);
    Object listener =
        DeadlineILFactory.proxy(
            new BasicObjectEndpoint(
                TcpEndpoint.getInstance("127.0.0.1", 1), UuidFactory.generate(), false),
            Duration.ofSeconds(2),
            MethodTypesTest.class.getClassLoader(),
            ModuleListener.class,
            Remote.class);
    List<Object> commands =
        List.of(
            new DriveCommand.Velocity(0.5, 0.1),
            new PanTiltCommand.PointAt(0.1, 0.2, 0.3),
            new FlightCommand.Arm(),
            new FlightCommand.TakeOff(10));
    List<Object> goals =
        List.of(
            new HomeGoal(1),
            new LegGoal(place, place, 1, Duration.ofMinutes(1)),
            new PathGoal(null, List.of(place, place), 1),
            new RasterGoal(new ArrayList<>(List.of(place, place)), 2, 1, false));
    Map<Class<?>, List<Object>> samples = new HashMap<>();
    samples.put(String.class, List.of("x"));
    samples.put(String[].class, List.of((Object) new String[] {"x"}));
    samples.put(UUID.class, List.of(UUID.randomUUID()));
    samples.put(LeaseHandle.class, List.of(new LeaseHandle(UUID.randomUUID())));
    samples.put(Duration.class, List.of(Duration.ofSeconds(1)));
    samples.put(LogLevel.class, List.of(LogLevel.DEBUG));
    samples.put(
        RemoteDiagnostics.DiagnosticType.class, List.of(RemoteDiagnostics.DiagnosticType.TEST));
    samples.put(List.class, List.of(List.of("a", "b"), new ArrayList<>(List.of("a"))));
    samples.put(GeoPosition.class, List.of(place));
    samples.put(Leg.class, List.of(new Leg(place, place)));
    samples.put(Clearance.class, List.of(new Clearance(Instant.EPOCH, "atrv1", 1, 2, 3)));
    samples.put(
        HeadingPercept.class,
        List.of(new HeadingPercept(Instant.EPOCH, "atrv1", 0, 0.1, 0, 1, 2, 3)));
    samples.put(CommandKey.class, List.of(new CommandKey(UUID.randomUUID())));
    samples.put(org.dfra.flow.effector.Command.class, commands);
    samples.put(org.dfra.behavior.Goal.class, goals);
    samples.put(ModuleListener.class, List.of(listener));
    samples.put(
        DeliveryPolicy.class,
        List.of(
            DeliveryPolicy.latestReading(),
            new DeliveryPolicy(EnumSet.allOf(DeliveryPolicy.EventKind.class), 10, 5)));
    samples.put(
        Delivery.class,
        List.of(
            new Delivery(
                "atrv1/laser",
                1,
                1,
                0,
                Instant.EPOCH,
                new ModuleEvent.NewReading(new EventFilterTest.Freight(new double[] {1, 2, 3})))));
    samples.put(Entry[].class, List.of((Object) new Entry[] {new Name("laser")}));
    samples.put(LookupLocator[].class, List.of((Object) new LookupLocator[] {locator()}));
    return samples;
  }

  private static LookupLocator locator() throws java.net.MalformedURLException {
    return new LookupLocator("jini://127.0.0.1:4160/");
  }

  private static List<Class<?>> remoteInterfaces() throws URISyntaxException, IOException {
    Path classes =
        Path.of(RemoteModule.class.getProtectionDomain().getCodeSource().getLocation().toURI());
    Path root = classes.resolve("org/dfra/river/remote");
    try (Stream<Path> files = Files.walk(root)) {
      List<Class<?>> found = new ArrayList<>();
      files
          .filter(file -> file.toString().endsWith(".class"))
          .map(file -> classes.relativize(file).toString().replace('/', '.'))
          .map(name -> load(name.substring(0, name.length() - ".class".length())))
          .filter(type -> type.isInterface() && Remote.class.isAssignableFrom(type))
          .forEach(found::add);
      assertThat(found).contains(RemoteModule.class).hasSizeGreaterThan(20);
      return found;
    } catch (UncheckedIOException e) {
      throw e.getCause();
    }
  }

  private static Class<?> load(String name) {
    try {
      return Class.forName(name);
    } catch (ClassNotFoundException e) {
      throw new AssertionError(name + " is among the classes", e);
    }
  }

  private static Method method(String name) {
    return Arrays.stream(Kinds.class.getMethods())
        .filter(method -> method.getName().equals(name))
        .findAny()
        .orElseThrow();
  }

  private static MethodTypes types(String name) {
    return MethodTypes.of(method(name), CONFIGURED);
  }

  /** What the server of a method reads of these arguments. */
  private static List<Object> call(Method method, Object... arguments)
      throws IOException, ClassNotFoundException {
    ByteArrayOutputStream bytes = new ByteArrayOutputStream();
    try (ObjectOutputStream out = new MarshalOutputStream(bytes, List.of())) {
      for (Object argument : arguments) {
        out.writeObject(argument);
      }
    }
    FilteredInvocationDispatcher.CallFilter filter =
        new FilteredInvocationDispatcher.CallFilter(SerialLimits.CALL);
    filter.narrow(MethodTypes.of(method, CONFIGURED));
    List<Object> read = new ArrayList<>();
    try (ObjectInputStream in =
        new net.jini.io.MarshalInputStream(
            ScannedStream.of(new ByteArrayInputStream(bytes.toByteArray()), SerialLimits.CALL),
            MethodTypesTest.class.getClassLoader(),
            false,
            null,
            List.of())) {
      in.setObjectInputFilter(filter);
      while (read.size() < arguments.length) {
        read.add(in.readObject());
      }
    }
    return read;
  }
}
