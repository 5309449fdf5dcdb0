package org.dfra.benchmarks.attack;

import java.util.List;
import java.util.Random;
import net.jini.core.lookup.ServiceID;
import net.jini.core.lookup.ServiceItem;
import net.jini.core.lookup.ServiceRegistrar;
import org.dfra.persona.Attributes;
import org.dfra.report.measurement.MeasuredValue;
import org.dfra.river.entry.Entries;

/**
 * Registers a module and a robot whose texts all contain terminal control characters, and checks
 * the output of an operator's commands meanwhile. The commands run on the attacker's core: their
 * JVMs would load the robot more than the attack does.
 */
public final class ForgedText extends OperatorVisibleAttack {

  private static final long LEASE_MILLIS = 30_000;
  private static final String SHOWN = "\\u009b2"; // of HostileModule's texts, made printable
  private static final List<String[]> COMMANDS =
      List.of(
          new String[] {"module", "list"},
          new String[] {"module", "list", "--json"},
          new String[] {"persona", "list"},
          new String[] {"lease", "list"});

  private final Random random = new Random(66);
  private final ServiceID module = new ServiceID(random.nextLong(), random.nextLong());
  private final ServiceID robot = new ServiceID(random.nextLong(), random.nextLong());
  private boolean isRegistered;
  private int next;

  /** Called by {@code TaskMain} by reflection. */
  public ForgedText() {}

  @Override
  protected void attack(Target target) throws Exception {
    register(target.registrar());
    terminal().run(COMMANDS.get(next++ % COMMANDS.size()));
  }

  /** Repeats the registration, which renews both leases. */
  private void register(ServiceRegistrar registrar) {
    List<Attributes> persona = List.of(HostileModule.persona());
    ServiceItem first =
        new ServiceItem(
            module, HostileModule.proxy(), Entries.toEntries(HostileModule.attributes()));
    ServiceItem second = new ServiceItem(robot, "a registrar", Entries.toEntries(persona));
    isRegistered |= attempt(() -> registrar.register(first, LEASE_MILLIS)) != null;
    isRegistered |= attempt(() -> registrar.register(second, LEASE_MILLIS)) != null;
  }

  @Override
  protected void end(Target target) throws Exception {
    if (isRegistered) {
      terminal().requireShown(SHOWN);
    }
  }

  @Override
  protected List<MeasuredValue> figures() {
    return terminal().figures();
  }
}
