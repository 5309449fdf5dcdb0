package org.dfra.core.robot;

import java.time.InstantSource;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.TreeMap;
import org.dfra.core.config.ConfigurationException;
import org.dfra.core.config.ModuleDescription;
import org.dfra.core.config.NearestName;
import org.dfra.core.config.Parameters;
import org.dfra.core.config.RobotDescription;
import org.dfra.core.config.RobotDescription.GroupDescription;
import org.dfra.core.directory.InMemoryModuleDirectory;
import org.dfra.core.module.ModuleClassFactory;
import org.dfra.core.module.ModuleContext;
import org.dfra.core.module.ModuleImpl;
import org.dfra.module.Module;

/**
 * Checks a robot's XML without starting it: every class exists, every driver can be constructed
 * from its parameters, and the modules that drivers need exist. Drivers are constructed and
 * discarded; none is started, so no device is opened and no state is stored.
 *
 * <p>A group whose JVM options may change its class path cannot be checked from another JVM, and is
 * skipped.
 */
public final class RobotDryRun {

  /** Prefix of options that do not change which classes a virtual machine finds. */
  private static final String TUNING = "-X";

  private static final String BOOT = "-Xboot";

  /**
   * Another module that a driver needs.
   *
   * @param parameter the parameter that may name it
   * @param kind its required type
   */
  private record Need(ModuleDescription by, String parameter, Class<?> kind) {}

  private final RobotDescription robot;
  private final Map<String, Class<?>> drivers = new TreeMap<>(); // classes of drivers, by module
  private final List<Need> needs = new ArrayList<>();
  private final List<String> faults = new ArrayList<>();

  private RobotDryRun(RobotDescription robot) {
    this.robot = robot;
    try (InMemoryModuleDirectory nobody = new InMemoryModuleDirectory()) {
      for (GroupDescription group : robot.groups()) {
        if (group.jvmOptions().stream().allMatch(RobotDryRun::isTuning)) {
          group.modules().forEach(module -> tryOut(module, nobody));
        }
      }
    }
  }

  /**
   * Checks all modules of a robot. A module that one of them names must exist; a needed module
   * without a name may be added later.
   *
   * @throws ConfigurationException with every fault in them, a line each
   */
  public static void check(RobotDescription robot) {
    RobotDryRun dryRun = new RobotDryRun(robot);
    dryRun.needs.forEach(dryRun::requireNamed);
    judge(dryRun.faults);
  }

  /**
   * The same for a complete robot: all modules that its modules need must exist.
   *
   * @throws ConfigurationException likewise
   */
  public static void checkComplete(RobotDescription robot) {
    RobotDryRun dryRun = new RobotDryRun(robot);
    dryRun.needs.forEach(dryRun::requireNamed);
    dryRun.needs.forEach(dryRun::requireAny);
    judge(dryRun.faults);
  }

  private static void judge(List<String> faults) {
    if (!faults.isEmpty()) {
      throw new ConfigurationException(String.join("\n", faults));
    }
  }

  private static boolean isTuning(String option) {
    return option.startsWith(TUNING) && !option.startsWith(BOOT);
  }

  private void tryOut(ModuleDescription module, InMemoryModuleDirectory nobody) {
    ModuleClassFactory classes = new ModuleClassFactory(module);
    try {
      Class<?> unusedServer = classes.load("server", module.serverClass());
      Class<?> unusedProxy = classes.load("proxy", module.proxyClass());
      ModuleContext context =
          new ModuleContext(
                  module.robot(), module.name(), module.parameters(), InstantSource.system())
              .withDirectory(nobody);
      ModuleImpl driver =
          classes.createDriver(
              context,
              Module.class,
              ModuleImpl.class,
              (parameter, kind) -> needs.add(new Need(module, parameter, kind)));
      drivers.put(module.name(), driver.getClass());
      driver.close();
    } catch (ConfigurationException e) {
      faults.add(String.valueOf(e.getMessage()));
    }
  }

  private void requireNamed(Need need) {
    Parameters parameters = need.by().parameters();
    String named = parameters.find(need.parameter()).orElse(null);
    if (named == null || mayBe(named, need.kind())) {
      return;
    }
    List<String> others = able(need.kind());
    ConfigurationException fault =
        parameters.fault(
            need.parameter(),
            "the name of a "
                + need.kind().getSimpleName()
                + " of "
                + robot.name()
                + NearestName.hint(
                    named,
                    others,
                    others.isEmpty()
                        ? "; it has none, so add one to its XML"
                        : "; it has " + String.join(", ", others)),
            null);
    faults.add(String.valueOf(fault.getMessage()));
  }

  /** Whether a module of that name exists, and has that type as far as known. */
  private boolean mayBe(String name, Class<?> kind) {
    Class<?> driver = drivers.get(name);
    return driver == null
        ? robot.modules().stream().anyMatch(each -> each.name().equals(name))
        : kind.isAssignableFrom(driver);
  }

  private List<String> able(Class<?> kind) {
    return drivers.entrySet().stream()
        .filter(each -> kind.isAssignableFrom(each.getValue()))
        .map(Map.Entry::getKey)
        .toList();
  }

  private void requireAny(Need need) {
    boolean isNamed = need.by().parameters().find(need.parameter()).isPresent();
    boolean isAllKnown = drivers.size() == robot.modules().size();
    if (isNamed || !isAllKnown || !able(need.kind()).isEmpty()) {
      return;
    }
    String what = need.kind().getSimpleName();
    ConfigurationException fault =
        new ModuleClassFactory(need.by())
            .fault(
                "it needs a " + what + ", and " + robot.name() + " has none; add one to its XML",
                null);
    faults.add(String.valueOf(fault.getMessage()));
  }
}
