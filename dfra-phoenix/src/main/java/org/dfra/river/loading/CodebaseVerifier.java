package org.dfra.river.loading;

import java.io.IOException;
import java.util.ArrayList;
import java.util.List;
import org.jspecify.annotations.Nullable;
import org.slf4j.Logger;
import org.slf4j.LoggerFactory;

/** Decides which codebases are loaded, and fetches those that are. */
final class CodebaseVerifier {

  private static final Logger LOG = LoggerFactory.getLogger(CodebaseVerifier.class);

  private final CodeTrust trust;
  private final JarDownload download;

  CodebaseVerifier(CodeTrust trust) {
    this.trust = trust;
    this.download = new JarDownload(trust.limits());
  }

  /**
   * Whether a jar is trusted by its digest alone.
   *
   * @return the reason, in words; null if the jar needs a trusted signature
   */
  @Nullable String digestTrustReason(CodebaseUrl url) {
    return trust.pinned().contains(url.digest()) ? "its digest is pinned" : null;
  }

  /**
   * Fetches the jars of a codebase and verifies them.
   *
   * @param byDigest for each URL the result of {@link #digestTrustReason}
   * @throws CodeRefusedException if one of them is not trusted
   * @throws IOException if one cannot be fetched
   */
  List<VerifiedJar> fetch(List<CodebaseUrl> urls, List<@Nullable String> byDigest)
      throws IOException {
    @Nullable TeamSigners team = TrustedCode.team();
    for (int i = 0; i < urls.size(); i++) {
      if (byDigest.get(i) == null && trust.signers().isEmpty() && team == null) {
        throw new CodeRefusedException(
            "codebase "
                + urls.get(i).text()
                + " refused: its digest is not pinned, and no key is trusted to sign code; name one"
                + " in the trust file (-D"
                + CodeTrust.PROPERTY
                + "), or pin the digest");
      }
    }
    List<VerifiedJar> jars = new ArrayList<>();
    for (int i = 0; i < urls.size(); i++) {
      CodebaseUrl url = urls.get(i);
      VerifiedJar jar = VerifiedJar.read(url, download.fetch(url), trust.limits());
      String why = byDigest.get(i);
      if (why == null) {
        jar.requireSigned(url, trust.signers(), team);
        why = "it is signed by a trusted key";
      }
      LOG.info("Loading code from {}: {}.", url.text(), why);
      jars.add(jar);
    }
    return jars;
  }
}
