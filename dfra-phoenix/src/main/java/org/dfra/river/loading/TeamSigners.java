package org.dfra.river.loading;

import java.security.cert.X509Certificate;
import java.util.List;
import java.util.Optional;

/** The keys that the authority of a team lets sign code. Thread-safe; its methods do not wait. */
public interface TeamSigners {

  /**
   * Why a key may not sign code for this computer now.
   *
   * @param chain the certificate of the key first
   * @return the rest of a sentence that begins with the signer's name, such as {@code "was revoked
   *     by the team's authority"}; empty if it may
   */
  Optional<String> refusal(List<X509Certificate> chain);
}
