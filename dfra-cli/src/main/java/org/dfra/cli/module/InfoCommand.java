package org.dfra.cli.module;

import java.util.LinkedHashMap;
import java.util.Map;
import java.util.concurrent.Callable;
import org.dfra.cli.team.ModuleArgument;
import org.dfra.cli.team.TeamDirectory;
import org.dfra.directory.ModuleListing;
import org.dfra.module.Diagnosable;
import org.dfra.module.Identification;
import org.dfra.module.Module;
import org.dfra.persona.Attributes;
import org.dfra.report.terminal.ExitCode;
import picocli.CommandLine.Command;
import picocli.CommandLine.Mixin;

/** {@code ./dfra module info}: a module's description and its lookup entries. */
@Command(name = "info", description = "Shows everything that a module publishes about itself.")
final class InfoCommand implements Callable<Integer> {

  private static final String SUFFIX = "Attributes";

  @Mixin
  @SuppressWarnings("NullAway.Init") // set by picocli before the call
  private ModuleArgument module;

  @Override
  public Integer call() throws Exception {
    try (TeamDirectory team = module.open()) {
      ModuleListing<Module> listing = module.find(team);
      Module asked = listing.module();
      Identification identification = asked.identification();
      Map<String, Object> info = new LinkedHashMap<>();
      info.put("module", listing.path());
      info.put("description", identification.description());
      info.put("author", identification.author());
      info.put("version", identification.version());
      info.put("kinds", ModuleKinds.names(asked));
      info.put("state", asked.readiness());
      info.put("stale", listing.stale());
      info.put("confirmed", listing.confirmed());
      info.put("id", listing.id().toString());
      info.put("logLevel", asked.logLevel());
      info.put("parameters", asked.parameters());
      if (asked instanceof Diagnosable diagnosable) {
        info.put("preconditions", diagnosable.preconditions());
        info.put("tests", diagnosable.tests());
        info.put("recoveries", diagnosable.recoveries());
      }
      info.put("history", asked.history());
      Map<String, Object> entries = new LinkedHashMap<>();
      for (Attributes each : listing.attributes()) {
        entries.put(each.getClass().getSimpleName().replace(SUFFIX, ""), each);
      }
      info.put("entries", entries);
      module.answer().details(info);
      return ExitCode.SUCCESS;
    }
  }
}
