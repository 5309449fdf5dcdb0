package org.dfra.benchmarks;

import java.io.Serializable;
import java.rmi.NoSuchObjectException;
import java.time.Duration;
import java.time.Instant;
import java.util.List;
import java.util.UUID;
import org.dfra.event.DeliveryPolicy;
import org.dfra.event.ModuleListener;
import org.dfra.event.Subscription;
import org.dfra.lease.ModuleLease;
import org.dfra.lifecycle.Readiness;
import org.dfra.module.Identification;
import org.dfra.module.LogLevel;
import org.dfra.module.Module;
import org.dfra.module.ModuleHistory;
import org.dfra.module.Parameter;
import org.dfra.persona.Attributes;
import org.dfra.persona.ChainAttributes;
import org.dfra.persona.ModuleAttributes;
import org.dfra.persona.SensorAttributes;

/** The proxy of a module that is only listed: no server implements it. */
record BenchModule(UUID id, String robot, String name) implements Module, Serializable {

  private static final int PER_ROBOT = 20;

  /** One of many modules; each robot has twenty. */
  static BenchModule of(int number) {
    return new BenchModule(
        UUID.randomUUID(), "robot" + number / PER_ROBOT, "module" + number % PER_ROBOT);
  }

  /** The attributes of the module with this number. */
  List<Attributes> attributes(int number) {
    return List.of(
        new ModuleAttributes(
            robot,
            name,
            "org.example.Driver" + number % 7,
            BenchRegistrar.HOST,
            "DFRA",
            "1",
            Readiness.READY,
            Instant.EPOCH,
            null,
            number % 3),
        new ChainAttributes(List.of(), List.of("Range")),
        new SensorAttributes(
            "Range", List.of("night"), 0, 1 + number % 40, null, List.of("No rain.")));
  }

  @Override
  public Identification identification() {
    return new Identification(robot, name, "a module of a benchmark", "DFRA", "1");
  }

  @Override
  public Readiness readiness() {
    return Readiness.READY;
  }

  @Override
  public Readiness awaitReadiness(Duration patience) {
    return Readiness.READY;
  }

  @Override
  public Subscription subscribe(ModuleListener listener, DeliveryPolicy policy)
      throws NoSuchObjectException {
    throw noServer();
  }

  @Override
  public ModuleLease acquireLease(Duration duration) throws NoSuchObjectException {
    throw noServer();
  }

  @Override
  public ModuleHistory history() {
    return new ModuleHistory(Instant.EPOCH, 1, 0, 0, Duration.ZERO, List.of());
  }

  @Override
  public LogLevel logLevel() {
    return LogLevel.ERROR;
  }

  @Override
  public void setLogLevel(LogLevel level) throws NoSuchObjectException {
    throw noServer();
  }

  @Override
  public List<Parameter> parameters() {
    return List.of();
  }

  @Override
  public void setParameter(String parameter, String text) throws NoSuchObjectException {
    throw noServer();
  }

  private NoSuchObjectException noServer() {
    return new NoSuchObjectException(robot + "/" + name + " has no server: it is of a benchmark");
  }
}
