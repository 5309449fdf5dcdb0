/**
 * Trusted code: how a virtual machine obtains classes that it lacks, and which it accepts.
 *
 * <pre>
 *   -dl jars --&gt; ClassServer --httpmd://host:port/x.jar;sha-256=...--&gt; annotation in streams
 *                                                                              |
 *      local class path first &lt;-- VerifiedClassProvider (RMIClassLoaderSpi) &lt;-/
 *                                     | CodeTrust: digest pinned, vouched for, or jar signed?
 *                                     v
 *               JarDownload --bytes--&gt; VerifiedJar --the same bytes--&gt; VerifiedLoader
 * </pre>
 *
 * <p>There is no sandbox: loaded code may do everything that this virtual machine may do. So only
 * trusted code is loaded. A digest in a URL does not establish trust, since it comes from the same
 * peer as the URL.
 *
 * <p>Enter at {@link org.dfra.river.loading.TrustedCode} in a main, at {@link
 * org.dfra.river.loading.ClassServer} to serve jars.
 */
@NullMarked
package org.dfra.river.loading;

import org.jspecify.annotations.NullMarked;
