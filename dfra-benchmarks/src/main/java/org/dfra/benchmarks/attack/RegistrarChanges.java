package org.dfra.benchmarks.attack;

import com.sun.jini.admin.DestroyAdmin;
import java.io.IOException;
import java.util.Arrays;
import java.util.List;
import java.util.Set;
import net.jini.admin.Administrable;
import net.jini.core.lookup.ServiceRegistrar;
import net.jini.lookup.DiscoveryAdmin;
import org.dfra.report.measurement.MeasuredValue;
import org.jspecify.annotations.Nullable;

/**
 * Repeatedly removes the robot's registrar from its groups, so that it is no longer discovered
 * there, and then destroys it.
 */
public final class RegistrarChanges extends AttackTask {

  private static final String ELSEWHERE = "elsewhere";

  private @Nullable Object admin;
  private Set<String> groups = Set.of();
  private int changed;
  private int destroyed;
  private int gone;

  /** Called by {@code TaskMain} by reflection. */
  public RegistrarChanges() {}

  @Override
  protected void prepare(Target target) throws Exception {
    ServiceRegistrar registrar = target.registrar();
    groups = groups(registrar);
    admin = SourceBoundProxies.of(((Administrable) registrar).getAdmin(), target.sockets());
  }

  @Override
  protected void attack(Target target) {
    if (admin instanceof DiscoveryAdmin discovery && admin instanceof DestroyAdmin end) {
      var unused = attempt(() -> change(discovery));
      var unusedEither = attempt(() -> destroy(end));
    } else {
      throw new IllegalStateException("not prepared, or no registrar's administration: " + admin);
    }
  }

  private boolean change(DiscoveryAdmin discovery) throws IOException {
    discovery.setMemberGroups(new String[] {ELSEWHERE});
    changed++;
    return true;
  }

  private boolean destroy(DestroyAdmin end) throws IOException {
    end.destroy();
    destroyed++;
    return true;
  }

  /** Checks whether the registrar runs, and is in its groups. */
  @Override
  protected void end(Target target) {
    try {
      gone = groups(target.registrar()).equals(groups) ? 0 : 1;
    } catch (IOException e) { // no server answers there
      gone = 1;
    }
  }

  private static Set<String> groups(ServiceRegistrar registrar) throws IOException {
    return Set.copyOf(Arrays.asList(registrar.getGroups()));
  }

  @Override
  protected List<MeasuredValue> figures() {
    return List.of(
        new MeasuredValue("changes of the registrar's groups by the attacker", changed, 0, ""),
        new MeasuredValue("ends of the registrar by the attacker", destroyed, 0, ""),
        new MeasuredValue("registrars gone, or out of their groups", gone, 0, ""));
  }
}
