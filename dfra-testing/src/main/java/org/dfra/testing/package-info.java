/**
 * Support for tests of modules, also of modules outside DFRA.
 *
 * <pre>
 *   test --&gt; JiniModuleDirectory --&gt; EmbeddedReggie &lt;--joins-- ServedModule (server, proxy, driver)
 *                    all of it in the test's own virtual machine
 * </pre>
 *
 * <p>Start at {@link org.dfra.testing.EmbeddedReggie}; {@code
 * docs/how-to/test-with-embedded-reggie.md} has a complete example.
 */
package org.dfra.testing;
