package org.dfra.benchmarks.attack;

import java.nio.file.Files;
import java.nio.file.Path;
import java.rmi.activation.ActivationGroupID;
import java.util.List;
import net.jini.id.Uuid;
import net.jini.id.UuidFactory;
import org.dfra.report.measurement.MeasuredValue;
import org.dfra.river.transport.TransportEndpoint;
import org.jspecify.annotations.Nullable;

/**
 * Registers a group with the attacker's class path at the robot's phoenix, under each well-known
 * identity and under random ones, and activates its program where that succeeds.
 */
public final class GroupRegistrations extends AttackTask {

  private @Nullable StrangersGroup group;
  private Path marker = Path.of("");
  private int registered;

  /** Called by {@code TaskMain} by reflection. */
  public GroupRegistrations() {}

  @Override
  protected void prepare(Target target) throws Exception {
    marker = target.folder().resolve("ran");
    group =
        new StrangersGroup(
            target.sockets().bound(new TransportEndpoint(target.host(), target.phoenixPort())),
            target.folder(),
            marker);
  }

  @Override
  protected void attack(Target target) {
    for (Uuid each : StrangersGroup.KNOWN) {
      var unused = attempt(() -> register(each));
    }
    var unused = attempt(() -> register(UuidFactory.generate()));
  }

  private ActivationGroupID register(Uuid identity) throws Exception {
    StrangersGroup ours = group;
    if (ours == null) {
      throw new IllegalStateException("not prepared");
    }
    ActivationGroupID id = ours.register(identity);
    registered++;
    var unused = ours.activate(id, identity);
    return id;
  }

  @Override
  protected List<MeasuredValue> figures() {
    return List.of(
        new MeasuredValue("groups registered by the attacker", registered, 0, ""),
        new MeasuredValue(
            "programs of the attacker that phoenix ran", Files.exists(marker) ? 1 : 0, 0, ""));
  }
}
