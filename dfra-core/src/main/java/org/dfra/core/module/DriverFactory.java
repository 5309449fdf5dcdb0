package org.dfra.core.module;

import java.util.ArrayList;
import java.util.HashSet;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.TreeSet;
import java.util.concurrent.ConcurrentHashMap;
import java.util.function.BiConsumer;
import java.util.function.Function;
import java.util.stream.Collectors;
import org.dfra.core.config.ConfigurationException;
import org.dfra.core.config.NearestName;
import org.dfra.core.config.Parameters;
import org.jspecify.annotations.Nullable;

/**
 * Constructs a driver, and finds all faults of its parameters. A driver's constructor throws at the
 * first invalid value. So it is called again without that parameter, until it completes: only then
 * are all its parameters known.
 */
final class DriverFactory {

  private final String module;
  private final ModuleContext context;
  private final BiConsumer<String, Class<?>> needs;
  private final Set<String> asked = ConcurrentHashMap.newKeySet();
  private final Set<String> refused = new HashSet<>();
  private final Map<String, Class<?>> needed = new LinkedHashMap<>();
  private final List<ConfigurationException> faults = new ArrayList<>();
  private volatile @Nullable String wrong; // the parameter refused last in the current attempt

  /**
   * @param module the module's path, {@code robot/name}
   * @param needs receives each other module that the driver needs: the parameter that may name it,
   *     and its required type
   */
  DriverFactory(String module, ModuleContext context, BiConsumer<String, Class<?>> needs) {
    this.module = module;
    this.context = context;
    this.needs = needs;
  }

  private final class Reading implements Parameters.ParameterAccessListener {
    @Override
    public void onRead(String name) {
      asked.add(name);
    }

    @Override
    public void onModuleReference(String name, Class<?> kind) {
      needed.put(name, kind);
    }

    @Override
    public void onInvalid(String name) {
      wrong = name;
    }
  }

  /**
   * Constructs the driver.
   *
   * @param constructor creates a driver from its context
   * @throws ConfigurationException with every fault, a line each
   */
  ModuleImpl construct(Function<ModuleContext, ModuleImpl> constructor) {
    try {
      Optional<ModuleImpl> driver = completed(constructor);
      driver.ifPresent(unused -> findUnknown());
      if (faults.isEmpty()) {
        return driver.orElseThrow();
      }
      driver.ifPresent(ModuleImpl::close);
      throw combinedFault();
    } finally {
      needed.forEach(needs);
    }
  }

  /** Empty if the constructor fails for a reason that cannot be bypassed. */
  private Optional<ModuleImpl> completed(Function<ModuleContext, ModuleImpl> constructor) {
    Parameters parameters = context.parameters().withListener(new Reading());
    while (true) {
      wrong = null;
      try {
        return Optional.of(constructor.apply(context.with(parameters)));
      } catch (ConfigurationException e) {
        @Nullable String name = wrong;
        if (name != null && refused.contains(name)) {
          return Optional.empty(); // it is missing only because it was removed
        }
        faults.add(e);
        if (name == null || !parameters.all().containsKey(name)) {
          return Optional.empty();
        }
        refused.add(name);
        parameters = parameters.without(name);
      }
    }
  }

  private void findUnknown() {
    for (Map.Entry<String, Parameters.Value> each : context.parameters().all().entrySet()) {
      if (!asked.contains(each.getKey())) {
        faults.add(
            new ConfigurationException(
                each.getValue().place()
                    + ": "
                    + module
                    + " has no parameter \""
                    + each.getKey()
                    + "\""
                    + NearestName.hint(
                        each.getKey(),
                        asked,
                        "; it has " + String.join(", ", new TreeSet<>(asked)))));
      }
    }
  }

  private ConfigurationException combinedFault() {
    return faults.size() == 1
        ? faults.get(0)
        : new ConfigurationException(
            faults.stream().map(Throwable::getMessage).collect(Collectors.joining("\n")));
  }
}
