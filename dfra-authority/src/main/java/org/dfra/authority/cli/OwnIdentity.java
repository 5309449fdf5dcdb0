package org.dfra.authority.cli;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Arrays;
import java.util.Optional;
import org.dfra.authority.Authority;
import org.dfra.cli.security.BundledPolicy;
import org.dfra.core.host.PrivateFiles;
import org.dfra.core.policy.Policy;
import org.dfra.core.policy.PolicyBundle;
import org.dfra.core.policy.PolicySignatureException;
import org.dfra.core.policy.PolicyStore;
import org.dfra.river.identity.IdentityException;
import org.dfra.river.identity.SecurityFiles;
import org.dfra.river.identity.TeamCertificates;
import org.dfra.river.security.SecureProcess;

/** The identity of the authority's computer, if it is of the same team: it gets what is new. */
final class OwnIdentity {

  private final Path folder;
  private final Authority authority;

  private OwnIdentity(Path folder, Authority authority) {
    this.folder = folder;
    this.authority = authority;
  }

  /** The identity in a state folder; empty if there is none, or it is of another authority. */
  static Optional<OwnIdentity> in(Path state, Authority authority)
      throws IOException, IdentityException {
    Path folder = SecureProcess.folder(state);
    Path certificate = folder.resolve(SecurityFiles.AUTHORITY);
    return Files.exists(certificate)
            && TeamCertificates.authority(Files.readAllBytes(certificate), certificate.toString())
                .equals(authority.certificate())
        ? Optional.of(new OwnIdentity(folder, authority))
        : Optional.empty();
  }

  /** Gives it the present list of revoked certificates. */
  void takeRevocations() throws IOException {
    Path list = folder.resolve(SecurityFiles.REVOKED);
    byte[] present = authority.revocations();
    if (!Files.exists(list) || !Arrays.equals(Files.readAllBytes(list), present)) {
      PrivateFiles.write(list, present);
    }
  }

  /**
   * Gives it a policy.
   *
   * @throws org.dfra.core.policy.PolicyReplacementException if its own one has the same version and
   *     another content, or a higher version
   */
  Policy takePolicy(PolicyBundle policy) throws IOException, PolicySignatureException {
    return new PolicyStore(folder, authority.certificate(), BundledPolicy.catalogue())
        .store(policy);
  }
}
