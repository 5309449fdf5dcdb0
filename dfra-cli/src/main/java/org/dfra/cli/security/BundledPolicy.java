package org.dfra.cli.security;

import java.security.cert.X509Certificate;
import java.util.Optional;
import org.dfra.core.config.ConfigurationException;
import org.dfra.core.policy.Policy;
import org.dfra.core.policy.PolicyXml;
import org.dfra.core.policy.method.InterfaceCatalogue;
import org.dfra.river.identity.IdentityException;
import org.dfra.river.identity.SecurityFiles;
import org.dfra.river.identity.SignedFiles;

/** The policy in a bundle, as far as joining is concerned with it. */
public final class BundledPolicy {

  private BundledPolicy() {}

  /** The interfaces that a policy may name: also those of classes in DFRA_CLASSPATH. */
  public static InterfaceCatalogue catalogue() {
    return InterfaceCatalogue.builtIn().withInterfacesOf(BundledPolicy.class.getClassLoader());
  }

  /**
   * Reads a policy and checks whose it is.
   *
   * @param team the team that it must be for
   * @param file its name, for messages
   * @throws ConfigurationException if it has faults: a line for each
   */
  public static Policy read(byte[] text, String team, String file) {
    Policy policy = PolicyXml.read(text, file, catalogue());
    if (!policy.team().equals(team)) {
      throw new ConfigurationException(
          policy.place()
              + ": the policy is of team "
              + policy.team()
              + " and not of "
              + team
              + "; write the right team into it");
    }
    return policy;
  }

  /** The policy of a bundle, with its signature checked; empty if it has none. */
  static Optional<Policy> of(Bundle bundle, X509Certificate authority, String team, String file)
      throws IdentityException {
    Optional<byte[]> text = bundle.file(SecurityFiles.POLICY);
    if (text.isEmpty()) {
      return Optional.empty();
    }
    SignedFiles.requirePolicySignature(
        text.get(), bundle.required(SecurityFiles.POLICY_SIGNATURE), authority, file);
    return Optional.of(read(text.get(), team, file));
  }
}
