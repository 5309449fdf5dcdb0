/** Attacks on the discovery of lookup services. */
package org.dfra.attack.discovery;
