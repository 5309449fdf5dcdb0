/** Attacks on the lookup service and by false registrations. */
package org.dfra.attack.registrar;
