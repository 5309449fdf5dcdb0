package org.dfra.river.security.robot;

import java.io.IOException;
import java.rmi.server.ServerNotActiveException;
import java.util.List;
import java.util.function.BooleanSupplier;
import java.util.function.Supplier;
import net.jini.export.ServerContext;
import org.dfra.geometry.GeoPosition;
import org.dfra.river.identity.FlooredClock;
import org.dfra.security.Caller;
import org.jspecify.annotations.Nullable;

/** A process's part of {@link PolicyControl}. */
final class PolicyControlService implements PolicyControl {

  private final FactFile facts;
  private final RequestFiles requests;
  private final FlooredClock clock;
  private final Supplier<@Nullable GeoPosition> position;
  private final BooleanSupplier isPositionNeeded;

  /**
   * @param clock the robot's
   * @param position the robot's; null if it is unknown
   * @param isPositionNeeded whether a rule needs it
   */
  PolicyControlService(
      FactFile facts,
      RequestFiles requests,
      FlooredClock clock,
      Supplier<@Nullable GeoPosition> position,
      BooleanSupplier isPositionNeeded) {
    this.facts = facts;
    this.requests = requests;
    this.clock = clock;
    this.position = position;
    this.isPositionNeeded = isPositionNeeded;
  }

  @Override
  public KnownFacts facts() throws IOException {
    return new KnownFacts(
        List.copyOf(facts.read().values()),
        clock.time().orElse(null),
        position.get(),
        isPositionNeeded.getAsBoolean());
  }

  @Override
  public void setFact(String name, String value) throws IOException {
    if (value.isEmpty()) {
      facts.remove(NamedFact.requireName(name));
    } else {
      facts.set(new NamedFact(name, value, clock.instant(), caller()));
    }
  }

  @Override
  public List<WaitingRequest> requests() throws IOException {
    return requests.waiting();
  }

  @Override
  public boolean answer(String id, boolean isConfirmed) throws IOException {
    return requests.answer(id, isConfirmed, caller());
  }

  /** The caller of the call in progress. */
  private static String caller() {
    try {
      for (Object each : ServerContext.getServerContext()) {
        if (each instanceof Caller caller) {
          return caller.toString();
        }
      }
      return "somebody unknown";
    } catch (ServerNotActiveException e) { // in this virtual machine
      return "the robot itself";
    }
  }
}
