package org.dfra.core.chain;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.awaitility.Awaitility.await;

import java.lang.reflect.Proxy;
import java.rmi.RemoteException;
import java.time.Duration;
import java.time.Instant;
import java.time.InstantSource;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.UUID;
import java.util.concurrent.CopyOnWriteArrayList;
import java.util.concurrent.CountDownLatch;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.atomic.AtomicInteger;
import java.util.concurrent.atomic.AtomicReference;
import org.dfra.core.config.Parameters;
import org.dfra.core.directory.InMemoryModuleDirectory;
import org.dfra.core.module.ModuleContext;
import org.dfra.core.module.ModuleImpl;
import org.dfra.core.module.SchemaImpl;
import org.dfra.core.module.SensorImpl;
import org.dfra.directory.DirectoryRegistration;
import org.dfra.directory.Locality;
import org.dfra.directory.ModuleListing;
import org.dfra.event.DeliveryPolicy;
import org.dfra.event.ModuleEvent;
import org.dfra.event.ModuleListener;
import org.dfra.event.Reading;
import org.dfra.event.Subscription;
import org.dfra.flow.sensor.Sensor;
import org.dfra.lifecycle.Readiness;
import org.dfra.persona.Attributes;
import org.dfra.persona.ModuleAttributes;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;

/** A chain in one virtual machine: two thermometers, and a schema that reports Kelvin. */
@Timeout(60)
class ChainTest {

  private static final Duration PATIENCE = Duration.ofSeconds(20);

  private record Celsius(double degrees, Instant measured) implements Reading {}

  private record Kelvin(double degrees, Instant measured) implements Reading {}

  private interface TemperatureSensor extends Sensor {}

  private final InMemoryModuleDirectory directory = new InMemoryModuleDirectory();
  private final Thermometer indoors = new Thermometer("atrv1", "indoors");
  private final Thermometer outdoors = new Thermometer("atrv1", "outdoors");
  private final Thermometer elsewhere = new Thermometer("atrv2", "indoors");
  private final ToKelvin schema = new ToKelvin();
  private final List<Double> reported = new CopyOnWriteArrayList<>();

  @AfterEach
  void end() {
    List.<ModuleImpl>of(schema, indoors, outdoors, elsewhere).forEach(ModuleImpl::close);
    directory.close();
  }

  private void start() {
    List.<ModuleImpl>of(indoors, outdoors, elsewhere, schema).forEach(ModuleImpl::start);
    Subscription unused =
        schema.subscribe(
            delivery -> {
              if (delivery.event() instanceof ModuleEvent.NewReading fresh) {
                reported.add(((Kelvin) fresh.reading()).degrees());
              }
            },
            DeliveryPolicy.keepLast(100));
  }

  private static void awaitClient(ModuleImpl module) {
    await().atMost(PATIENCE).until(() -> module.readiness() == Readiness.ACTIVE);
  }

  private static void awaitNoClient(ModuleImpl module) {
    await().atMost(PATIENCE).until(() -> module.readiness() == Readiness.READY);
  }

  @Test
  void findsItsInputsOnItsOwnRobotAsTheyComeAndGo() {
    DirectoryRegistration first = directory.add(indoors);
    directory.add(elsewhere);
    start();
    awaitClient(indoors);
    indoors.measure(20);
    await().atMost(PATIENCE).until(() -> reported.contains(293.15));

    directory.add(outdoors); // comes later
    awaitClient(outdoors);
    outdoors.measure(-5);
    await().atMost(PATIENCE).until(() -> reported.contains(268.15));

    first.close(); // goes
    awaitNoClient(indoors);
    indoors.measure(30);
    outdoors.measure(-6);
    await().atMost(PATIENCE).until(() -> reported.contains(267.15));
    assertThat(reported).containsExactly(293.15, 268.15, 267.15);
    assertThat(elsewhere.readiness()).as("that of another robot").isEqualTo(Readiness.READY);
  }

  @Test
  void listensToOneUntilThatIsGone() {
    ToKelvin single =
        new ToKelvin(false, ChainTest.context("atrv1", "single").withDirectory(directory));
    DirectoryRegistration first = directory.add(indoors);
    List.<ModuleImpl>of(indoors, outdoors, elsewhere, single).forEach(ModuleImpl::start);
    awaitClient(indoors);
    directory.add(outdoors);
    directory.add(elsewhere);
    first.close();
    awaitClient(outdoors); // the next in line; until then it had no client
    awaitNoClient(indoors);
    directory.add(indoors);
    outdoors.measure(-5); // a round through the directory's thread and back
    assertThat(outdoors.readiness()).isEqualTo(Readiness.ACTIVE);
    assertThat(outdoors.leases().clients()).isEqualTo(1);
    single.close();
    awaitNoClient(outdoors);
  }

  @Test
  void listensToTheOneThatAParameterNames() {
    ModuleContext context =
        new ModuleContext(
            "atrv1",
            "single",
            Parameters.of("atrv1/single", Map.of("sensor", "outdoors")),
            InstantSource.system());
    directory.add(indoors);
    try (ToKelvin single = new ToKelvin(false, context.withDirectory(directory))) {
      List.<ModuleImpl>of(indoors, outdoors, single).forEach(ModuleImpl::start);
      directory.add(outdoors);
      awaitClient(outdoors);
      assertThat(indoors.readiness()).isEqualTo(Readiness.READY);
    }
  }

  @Test
  void isRewiredWhileItRuns() {
    directory.add(indoors);
    directory.add(outdoors);
    directory.add(elsewhere);
    start();
    schema.setInputs(List.of("atrv1/indoors"));
    awaitClient(indoors);
    awaitNoClient(outdoors);
    outdoors.measure(-5);
    indoors.measure(20);
    await().atMost(PATIENCE).until(() -> reported.contains(293.15));

    schema.setInputs(List.of("atrv2/indoors"));
    assertThat(schema.inputs()).containsExactly("atrv2/indoors");
    awaitClient(elsewhere);
    awaitNoClient(indoors);
    indoors.measure(21);
    elsewhere.measure(-10);
    await().atMost(PATIENCE).until(() -> reported.contains(263.15));
    assertThat(reported).containsExactly(293.15, 263.15);
  }

  @Test
  void keepsItsWiringWhenANewOneIsRefused() {
    directory.add(indoors);
    directory.add(schema);
    start();
    schema.setInputs(List.of("atrv1/indoors"));
    assertThatThrownBy(() -> schema.setInputs(List.of("atrv1/sauna")))
        .isInstanceOf(IllegalArgumentException.class)
        .hasMessage("atrv1/to_kelvin cannot be wired to atrv1/sauna: there is no such module");
    assertThatThrownBy(() -> schema.setInputs(List.of("atrv1/indoors", "atrv1/outdoors")))
        .hasMessage("atrv1/to_kelvin takes 1 inputs (Celsius) or none, but was given 2");
    ToKelvin other = new ToKelvin("again");
    directory.add(other);
    assertThatThrownBy(() -> schema.setInputs(List.of("atrv1/again")))
        .hasMessage(
            "atrv1/to_kelvin cannot be wired to atrv1/again: it is not of type TemperatureSensor");
    assertThat(schema.inputs()).containsExactly("atrv1/indoors");
    awaitClient(indoors);
    other.close();
  }

  @Test
  void subscribesAgainToAModuleThatWasRestartedInPlace() {
    UUID id = UUID.randomUUID();
    AtomicReference<Thermometer> behind = new AtomicReference<>(indoors);
    TemperatureSensor proxy = proxy(behind, new AtomicInteger());
    directory.put(id, proxy, attributes("first life"), Locality.SAME_VM);
    start();
    awaitClient(indoors);
    indoors.close();
    Thermometer reborn = new Thermometer("atrv1", "indoors");
    reborn.start();
    behind.set(reborn);
    directory.put(id, proxy, attributes("second life"), Locality.SAME_VM); // it is listed again
    awaitClient(reborn);
    reborn.measure(20);
    await().atMost(PATIENCE).until(() -> reported.contains(293.15));
    reborn.close();
  }

  @Test
  void triesAgainWhereASubscriptionFailsInWhicheverWay() {
    AtomicInteger failures = new AtomicInteger(1);
    TemperatureSensor proxy = proxy(new AtomicReference<>(indoors), failures);
    directory.put(UUID.randomUUID(), proxy, attributes("only life"), Locality.SAME_VM);
    start();
    awaitClient(indoors);
    assertThat(failures.get()).isNegative();
    indoors.measure(20);
    await().atMost(PATIENCE).until(() -> reported.contains(293.15));
  }

  @Test
  void aModuleThatDoesNotAnswerDelaysNoOther() throws Exception {
    CountDownLatch silence = new CountDownLatch(1);
    CountDownLatch called = new CountDownLatch(3);
    for (int i = 0; i < 3; i++) {
      directory.put(
          UUID.randomUUID(),
          silent(silence, called),
          attributes("silent" + i, "DFRA"),
          Locality.REMOTE);
    }
    start();
    assertThat(called.await(PATIENCE.toSeconds(), TimeUnit.SECONDS))
        .as("all three are called at the same time")
        .isTrue();
    directory.add(outdoors);
    awaitClient(outdoors);
    outdoors.measure(-5);
    await().atMost(PATIENCE).until(() -> reported.contains(268.15));
    silence.countDown();
  }

  private static TemperatureSensor silent(CountDownLatch silence, CountDownLatch called) {
    return (TemperatureSensor)
        Proxy.newProxyInstance(
            TemperatureSensor.class.getClassLoader(),
            new Class<?>[] {TemperatureSensor.class},
            (self, method, arguments) -> {
              switch (method.getName()) {
                case "equals":
                  return self == arguments[0];
                case "hashCode":
                  return System.identityHashCode(self);
                case "subscribe":
                  called.countDown();
                  silence.await();
                  throw new RemoteException("it never answered");
                default:
                  return "a silent module";
              }
            });
  }

  @Test
  void saysWhichInputIsMissing() {
    start();
    schema.setInputs(List.of());
    assertThat(schema.missing()).contains("there is no TemperatureSensor on atrv1");
    directory.add(indoors);
    awaitClient(indoors);
    assertThat(schema.missing()).isEmpty();
  }

  /** What stays when the module behind it dies and comes back, as a smart proxy does. */
  private static TemperatureSensor proxy(
      AtomicReference<Thermometer> behind, AtomicInteger failures) {
    return (TemperatureSensor)
        Proxy.newProxyInstance(
            TemperatureSensor.class.getClassLoader(),
            new Class<?>[] {TemperatureSensor.class},
            (self, method, arguments) -> {
              switch (method.getName()) {
                case "equals":
                  return self == arguments[0];
                case "hashCode":
                  return 1;
                case "subscribe":
                  if (failures.getAndDecrement() > 0) {
                    throw new IllegalStateException("a class of it cannot be loaded");
                  }
                  return behind
                      .get()
                      .subscribe((ModuleListener) arguments[0], (DeliveryPolicy) arguments[1]);
                default:
                  return "a proxy";
              }
            });
  }

  private static List<Attributes> attributes(String author) {
    return attributes("indoors", author);
  }

  private static List<Attributes> attributes(String name, String author) {
    return List.of(
        new ModuleAttributes(
            "atrv1",
            name,
            "a thermometer",
            "localhost",
            author,
            "1",
            Readiness.READY,
            Instant.EPOCH,
            Instant.EPOCH,
            0));
  }

  @Test
  void saysThatItNeedsADirectory() {
    try (ToKelvin alone = new ToKelvin(true, context("atrv1", "alone"))) {
      assertThatThrownBy(alone::start)
          .hasMessage(
              "atrv1/alone needs other modules and was made without a directory; give its context"
                  + " one by ModuleContext.withDirectory");
      assertThat(alone.readiness()).isEqualTo(Readiness.FAILED);
    }
  }

  private static ModuleContext context(String robot, String name) {
    return new ModuleContext(
        robot, name, Parameters.of(robot + "/" + name, Map.of()), InstantSource.system());
  }

  private static final class Thermometer extends SensorImpl implements TemperatureSensor {

    Thermometer(String robot, String name) {
      super(context(robot, name), "a thermometer", "DFRA", "1", List.of("Celsius"), List.of());
    }

    void measure(double degrees) {
      publish(new Celsius(degrees, Instant.EPOCH));
    }

    @Override
    public double updateRate() {
      return 0;
    }

    @Override
    protected void onStart() {
      transitionTo(Readiness.READY);
    }

    @Override
    protected void onClose() {}
  }

  private final class ToKelvin extends SchemaImpl {

    ToKelvin() {
      this("to_kelvin");
    }

    ToKelvin(String name) {
      this(true, ChainTest.context("atrv1", name).withDirectory(directory));
    }

    ToKelvin(boolean all, ModuleContext context) {
      super(context, "tells Kelvin", "DFRA", "1", List.of("Kelvin"));
      if (all) {
        declareInputFromAll(TemperatureSensor.class, Celsius.class, this::take);
      } else {
        declareInput(TemperatureSensor.class, "sensor", Celsius.class, this::take);
      }
    }

    Optional<String> missing() {
      return missingInput();
    }

    private void take(ModuleListing<?> source, Celsius reading) {
      publish(new Kelvin(reading.degrees() + 273.15, reading.measured()));
    }

    @Override
    protected List<Attributes> additionalAttributes() {
      return List.of();
    }

    @Override
    protected void onStart() {
      super.onStart();
      transitionTo(Readiness.READY);
    }
  }
}
