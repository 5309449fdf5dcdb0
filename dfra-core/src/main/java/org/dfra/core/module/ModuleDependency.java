package org.dfra.core.module;

import java.util.List;
import org.dfra.directory.ModuleListing;
import org.dfra.directory.ModuleQuery;
import org.dfra.lifecycle.Readiness;
import org.dfra.module.Module;
import org.dfra.module.NotReadyException;

/**
 * A module that another needs for its work: any of that kind on its own robot, or the one that a
 * parameter names.
 *
 * @param <M> its type
 */
public final class ModuleDependency<M extends Module> {

  private final ModuleContext context;
  private final String parameter;
  private final ModuleQuery<M> query;

  private ModuleDependency(ModuleContext context, String parameter, ModuleQuery<M> query) {
    this.context = context;
    this.parameter = parameter;
    this.query = query;
  }

  /**
   * Declares a dependency, without resolving it.
   *
   * @param context the context of the dependent module
   * @param parameter the parameter that names another module of the robot; if it is not set, any of
   *     the type
   */
  public static <M extends Module> ModuleDependency<M> of(
      ModuleContext context, Class<M> kind, String parameter) {
    ModuleQuery<M> any = ModuleQuery.of(kind).robot(context.robot());
    return new ModuleDependency<>(
        context,
        parameter,
        context.parameters().moduleName(parameter, kind).map(any::name).orElse(any));
  }

  /**
   * The best module available now.
   *
   * @throws NotReadyException if there is none; the message names the module, and the place that
   *     names it
   */
  public M resolve() {
    List<ModuleListing<M>> found = context.directory().find(query);
    if (found.isEmpty()) {
      throw new NotReadyException(
          context.path(),
          Readiness.INITIALIZING,
          "it needs a "
              + query
              + ", and there is none"
              + context
                  .parameters()
                  .place(parameter)
                  .map(place -> "; " + place + " names it")
                  .orElse("; add one to the robot's XML"));
    }
    return found.get(0).module();
  }

  /** A proxy for the best module at each call; see {@code ModuleDirectory.proxyFor}. */
  public M failoverProxy() {
    return context.directory().proxyFor(query);
  }
}
