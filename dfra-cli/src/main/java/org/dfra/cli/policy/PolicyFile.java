package org.dfra.cli.policy;

import java.nio.file.Files;
import java.nio.file.Path;
import org.dfra.cli.team.PhoenixOptions.StateOption;
import org.dfra.core.policy.BuiltInPolicies;
import org.dfra.core.policy.Policy;
import org.dfra.core.policy.PolicyStore;
import org.dfra.core.policy.PolicyXml;
import org.dfra.core.policy.method.InterfaceCatalogue;
import org.jspecify.annotations.Nullable;
import picocli.CommandLine.Mixin;
import picocli.CommandLine.Parameters;

/** The policy that a command is about. A picocli mix-in. */
final class PolicyFile {

  /** The team of the built-in policy, until a team has one of its own. */
  private static final String NO_TEAM = "field";

  @Parameters(
      arity = "0..1",
      paramLabel = "FILE",
      description =
          "The policy (default: security/policy.xml in the state folder, or else the one that comes"
              + " with DFRA).")
  private @Nullable Path file;

  @Mixin
  @SuppressWarnings("NullAway.Init") // set by picocli before the call
  private StateOption state;

  /** The interfaces that a policy may name: also those of classes in DFRA_CLASSPATH. */
  static InterfaceCatalogue catalogue() {
    return InterfaceCatalogue.builtIn().withInterfacesOf(PolicyFile.class.getClassLoader());
  }

  /**
   * The policy.
   *
   * @throws org.dfra.core.config.ConfigurationException with every fault in it, a line each
   */
  Policy read() {
    if (file != null) {
      return PolicyXml.read(file, catalogue());
    }
    Path stored = state.folder().resolve("security").resolve(PolicyStore.POLICY);
    return Files.exists(stored)
        ? PolicyXml.read(stored, catalogue())
        : BuiltInPolicies.standard(NO_TEAM);
  }
}
